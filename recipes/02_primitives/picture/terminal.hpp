#pragma once

/// \file
/// \brief A picture in a terminal: two pixels a character, by half blocks in 24-bit colours.

#include "02_primitives/picture/canvas.hpp"

#include <string>

namespace cookbook
{

/// The mean colour of the part of a picture that one of columns × rows cells covers.
inline Colour cell_mean(const Picture& picture, int column, int columns, int row, int rows)
{
  const auto from = [](int i, int cells, int size)
  { return static_cast<int>(static_cast<std::int64_t>(i) * size / cells); };
  const int x0 = from(column, columns, picture.width), y0 = from(row, rows, picture.height);
  const int x1 = std::max(from(column + 1, columns, picture.width), x0 + 1);
  const int y1 = std::max(from(row + 1, rows, picture.height), y0 + 1);
  std::array<std::int64_t, 3> sum{};
  for (int y = y0; y < y1; ++y)
  {
    for (int x = x0; x < x1; ++x)
    {
      const Colour c =
          to_colour(picture.pixels[row_start(picture, y) + static_cast<std::size_t>(x)]);
      sum = {sum[0] + c.r, sum[1] + c.g, sum[2] + c.b};
    }
  }
  const std::int64_t count = static_cast<std::int64_t>(x1 - x0) * (y1 - y0);
  const auto mean = [count](std::int64_t s) { return static_cast<std::uint8_t>(s / count); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

/// The numbers of a colour as an ANSI escape sequence has them.
inline std::string ansi_numbers(const Colour& c)
{
  return std::to_string(c.r) + ';' + std::to_string(c.g) + ';' + std::to_string(c.b);
}

/// The picture as `rows` lines of `columns` characters ▀, whose upper half has one colour and whose
/// lower half another; empty for an empty picture or without a place.
inline std::string to_terminal(const Picture& picture, int columns, int rows)
{
  std::string text;
  if (picture.width <= 0 || picture.height <= 0 || columns <= 0)
  {
    return text;
  }
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const Colour upper = cell_mean(picture, column, columns, 2 * row, 2 * rows);
      const Colour lower = cell_mean(picture, column, columns, 2 * row + 1, 2 * rows);
      text += "\x1b[38;2;" + ansi_numbers(upper) + ";48;2;" + ansi_numbers(lower) + "m\u2580";
    }
    text += "\x1b[0m\n";
  }
  return text;
}

} // namespace cookbook
