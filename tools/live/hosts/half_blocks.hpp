#pragma once

/// \file
/// \brief A picture in a terminal: two pixels a character, by half blocks in 24-bit colours.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <string>

namespace cookbook::live
{

/// A picture that is shown: RGBA bytes, row by row from the top.
struct Shown
{
  int width, height;
  std::span<const std::uint32_t> pixels;
};

/// The mean colour of a part of a picture: red, green, blue.
using Mean = std::array<int, 3>;

/// The mean colour of the part of a picture that one of columns × rows cells covers.
inline Mean cell_mean(const Shown& picture, int column, int columns, int row, int rows)
{
  const auto from = [](int i, int cells, int size)
  { return static_cast<int>(static_cast<std::int64_t>(i) * size / cells); };
  const int x0 = from(column, columns, picture.width), y0 = from(row, rows, picture.height);
  const int x1 = std::max(from(column + 1, columns, picture.width), x0 + 1);
  const int y1 = std::max(from(row + 1, rows, picture.height), y0 + 1);
  Mean sum{};
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      const std::size_t at = std::size_t(y) * std::size_t(picture.width) + std::size_t(x);
      const auto bytes = std::bit_cast<std::array<std::uint8_t, 4>>(picture.pixels[at]);
      sum = {sum[0] + bytes[0], sum[1] + bytes[1], sum[2] + bytes[2]};
    }
  }
  const int count = (x1 - x0) * (y1 - y0);
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

/// The escape sequence of a colour: `layer` is 38 for the character, 48 for what is behind it.
inline std::string ansi_colour(int layer, const Mean& c)
{
  return "\x1b[" + std::to_string(layer) + ";2;" + std::to_string(c[0]) + ';' +
         std::to_string(c[1]) + ';' + std::to_string(c[2]) + 'm';
}

/// One of `rows` lines of `columns` characters ▀, whose upper half has one colour and whose lower
/// half another; a colour is written where it changes.
inline std::string half_block_row(const Shown& picture, int columns, int row, int rows)
{
  std::string text;
  Mean upper{-1, 0, 0}, lower{-1, 0, 0};
  for (int column = 0; column < columns; ++column)
  {
    const Mean above = cell_mean(picture, column, columns, 2 * row, 2 * rows);
    const Mean below = cell_mean(picture, column, columns, 2 * row + 1, 2 * rows);
    text += above != upper ? ansi_colour(38, above) : "";
    text += below != lower ? ansi_colour(48, below) : "";
    text += "\u2580";
    upper = above;
    lower = below;
  }
  return text + "\x1b[0m";
}

} // namespace cookbook::live
