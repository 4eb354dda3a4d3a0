#pragma once

/// \file
/// \brief A picture in memory: colours, a depth for each pixel, and the book's palette.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cookbook
{

// [colour]
/// A colour as four bytes, in the order in which pixels are stored.
struct Colour
{
  std::uint8_t r = 0;   ///< red
  std::uint8_t g = 0;   ///< green
  std::uint8_t b = 0;   ///< blue
  std::uint8_t a = 255; ///< opacity, from 0 to 255
};

/// The colour as a pixel: the bytes r, g, b, a in memory.
constexpr std::uint32_t to_pixel(const Colour& colour)
{
  return std::bit_cast<std::uint32_t>(colour);
}

/// The colour of a pixel.
constexpr Colour to_colour(std::uint32_t pixel)
{
  return std::bit_cast<Colour>(pixel);
}
// [colour]

/// A colour between two: `part` of 255 of the second, in whole numbers; opaque.
constexpr Colour mixed(const Colour& under, const Colour& over, int part)
{
  const auto channel = [part](int below, int above)
  { return static_cast<std::uint8_t>((below * (255 - part) + above * part + 127) / 255); };
  return {channel(under.r, over.r), channel(under.g, over.g), channel(under.b, over.b), 255};
}

/// The colour in a light of this brightness: 0 is black, 1 leaves it as it is.
constexpr Colour lit(const Colour& colour, double brightness)
{
  const double kept = brightness > 0 ? std::min(brightness, 255.0) : 0.0;
  const auto channel = [kept](int c)
  { return static_cast<std::uint8_t>(std::min(c * kept + 0.5, 255.0)); };
  return {channel(colour.r), channel(colour.g), channel(colour.b), colour.a};
}

/// The book's colours: body A blue, body B orange, overlap and depth red, text in ink.
struct Palette
{
  Colour sky;     ///< at the top of the picture
  Colour horizon; ///< at its bottom
  Colour ground;  ///< the floor
  Colour grid;    ///< lines on the floor
  Colour shadow;  ///< laid over the floor: its opacity says how dark
  Colour ink;     ///< normals, text
  Colour muted;   ///< bodies that do not matter, bodies asleep
  Colour a;       ///< body A
  Colour b;       ///< body B
  Colour overlap; ///< overlap, depth, impulses
  Colour good;    ///< what is right
};

/// The palette of a light page.
constexpr Palette light_palette()
{
  return {{255, 255, 255},  {238, 242, 246}, {236, 239, 242}, {198, 206, 214},
          {29, 39, 51, 70}, {29, 39, 51},    {148, 158, 170}, {28, 95, 168},
          {224, 123, 0},    {200, 16, 46},   {35, 128, 63}};
}

/// The palette of a dark page.
constexpr Palette dark_palette()
{
  return {{22, 25, 29},   {31, 36, 42},    {40, 46, 53},    {66, 75, 85},
          {0, 0, 0, 120}, {232, 236, 241}, {112, 123, 135}, {109, 177, 255},
          {255, 171, 74}, {255, 107, 127}, {98, 207, 132}};
}

// [picture]
/// Pixels, and how deep the camera sees at each of them.
struct Picture
{
  int width = 0;                     ///< [pixels]
  int height = 0;                    ///< [pixels]
  std::vector<std::uint32_t> pixels; ///< bytes r, g, b, a; row by row, from the top
  std::vector<float> depth; ///< as the projection makes it: −1 at the near plane, 1 at the far
  int samples = 1;          ///< pixels drawn for one that is shown, along each side
};
// [picture]

/// A picture of width × height pixels that are shown, each made of samples × samples drawn ones.
///
/// It is black and empty. Sizes below zero are zero; samples are 1, 2 or 4, others the next below.
inline Picture make_picture(int width, int height, int samples = 1)
{
  const int n = samples >= 4 ? 4 : samples >= 2 ? 2 : 1;
  Picture picture{std::max(width, 0) * n, std::max(height, 0) * n, {}, {}, n};
  const auto count =
      static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.pixels.assign(count, to_pixel({0, 0, 0}));
  picture.depth.assign(count, 1.0F);
  return picture;
}

/// The number of a row's first pixel.
inline std::size_t row_start(const Picture& picture, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
}

/// Paints all of the picture, from one colour at the top to another at the bottom, and forgets
/// all depths.
inline void clear(Picture& picture, const Colour& top, const Colour& bottom)
{
  for (int y = 0; y < picture.height; ++y)
  {
    const int part = picture.height > 1 ? 255 * y / (picture.height - 1) : 0;
    std::fill_n(
        picture.pixels.begin() + static_cast<std::ptrdiff_t>(row_start(picture, y)), picture.width,
        to_pixel(mixed(top, bottom, part)));
  }
  std::fill(picture.depth.begin(), picture.depth.end(), 1.0F);
}

/// Paints all of the picture in one colour and forgets all depths.
inline void clear(Picture& picture, const Colour& colour)
{
  clear(picture, colour, colour);
}

/// Paints the palette's sky and forgets all depths.
inline void clear(Picture& picture, const Palette& palette)
{
  clear(picture, palette.sky, palette.horizon);
}

// [mean_pixel]
/// The mean of n × n pixels, the upper left of which is `first`, in rows of `width`.
///
/// The four bytes are added two at a time, 16 bits for each sum: r and b, then g and a.
template <int n>
std::uint32_t mean_pixel(const std::uint32_t* first, std::size_t width)
{
  constexpr unsigned shift = n == 4 ? 4 : 2; // divides by n²
  constexpr std::uint32_t half = 0x00010001U << (shift - 1), bytes = 0x00ff00ffU;
  std::uint32_t red_blue = half, green_alpha = half;
  constexpr std::size_t side = n;
  for (std::size_t i = 0; i < side * side; ++i)
  {
    const std::uint32_t pixel = first[i / side * width + i % side];
    red_blue += pixel & bytes;
    green_alpha += (pixel >> 8) & bytes;
  }
  return ((red_blue >> shift) & bytes) | (((green_alpha >> shift) & bytes) << 8);
}
// [mean_pixel]

/// The picture that is shown, of samples n: each block of n × n pixels becomes their mean.
template <int n>
Picture averaged(const Picture& picture)
{
  Picture small = make_picture(picture.width / n, picture.height / n);
  const std::size_t width = static_cast<std::size_t>(picture.width);
  for (int y = 0; y < small.height; ++y)
  {
    const std::size_t to = row_start(small, y), from = row_start(picture, y * n);
    for (std::size_t x = 0; x < static_cast<std::size_t>(small.width); ++x)
    {
      small.pixels[to + x] = mean_pixel<n>(&picture.pixels[from + n * x], width);
      small.depth[to + x] = picture.depth[from + n * x];
    }
  }
  return small;
}

/// The picture that is shown: the mean of each block of drawn pixels, the depth of its upper left.
inline Picture shown(const Picture& picture)
{
  return picture.samples == 4   ? averaged<4>(picture)
         : picture.samples == 2 ? averaged<2>(picture)
                                : picture;
}

} // namespace cookbook
