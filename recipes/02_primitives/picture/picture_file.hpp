#pragma once

/// \file
/// \brief A picture as a file (PPM), and as one number that tells pictures apart.

#include "02_primitives/picture/canvas.hpp"

#include <string>

namespace cookbook
{

/// The shown picture as a plain PPM file, which most viewers of pictures open: a head of three
/// numbers, then the bytes r, g, b of each pixel.
inline std::string to_ppm(const Picture& picture)
{
  const Picture small = shown(picture);
  std::string file =
      "P6\n" + std::to_string(small.width) + ' ' + std::to_string(small.height) + "\n255\n";
  for (const std::uint32_t pixel : small.pixels)
  {
    const Colour c = to_colour(pixel);
    for (const std::uint8_t byte : {c.r, c.g, c.b})
    {
      file += static_cast<char>(byte);
    }
  }
  return file;
}

/// A number of 64 bits for a picture: FNV-1a over its size and the bytes r, g, b of its pixels.
inline std::uint64_t picture_hash(const Picture& picture)
{
  std::uint64_t hash = 14695981039346656037ULL;
  const auto eat = [&hash](std::uint32_t byte) { hash = (hash ^ byte) * 1099511628211ULL; };
  eat(static_cast<std::uint32_t>(picture.width));
  eat(static_cast<std::uint32_t>(picture.height));
  for (const std::uint32_t pixel : picture.pixels)
  {
    const Colour c = to_colour(pixel);
    eat(c.r);
    eat(c.g);
    eat(c.b);
  }
  return hash;
}

} // namespace cookbook
