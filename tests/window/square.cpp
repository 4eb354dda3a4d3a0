/// \file
/// \brief The figure that windows and terminals are tested with: a square that moves.

#include "tools/live/page.hpp"

#include <array>
#include <bit>

extern const char* const cookbook_live_name;
const char* const cookbook_live_name = "square";

namespace cookbook::live
{

namespace
{

constexpr int width = 320, height = 200;

/// A colour as a pixel.
std::uint32_t pixel(std::uint8_t r, std::uint8_t g, std::uint8_t b)
{
  return std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{r, g, b, 255});
}

/// A square on a ground, which goes on at the left where it has left at the right.
std::vector<std::uint32_t> drawn(int left, int top, int size, bool orange, bool dark)
{
  const std::uint32_t ground = dark ? pixel(21, 27, 35) : pixel(238, 242, 246);
  const std::uint32_t colour = orange ? pixel(224, 123, 0) : pixel(28, 95, 168);
  std::vector<std::uint32_t> pixels(std::size_t(width * height), ground);
  for (int y = top; y < top + size; ++y)
  {
    for (int x = left; x < left + size; ++x)
    {
      if (y >= 0 && y < height)
      {
        pixels[std::size_t(y * width + (x % width + width) % width)] = colour;
      }
    }
  }
  return pixels;
}

} // namespace

void figure(Page& page)
{
  static int x = 0, y = 0;
  static std::vector<std::uint32_t> pixels;
  if (page.begins())
  {
    x = 20;
    y = 60;
  }
  const int size = int(page.slider("size", 10, 110, 60, "px"));
  const bool orange = page.choice("colour", {"blue", "orange"}) == 1;
  const bool moves = page.toggle("moves", true);
  if (page.button("jump"))
  {
    y = 120 - y;
  }
  if (page.pointer().down)
  {
    x = int(page.pointer().at.x()) - size / 2;
    y = int(page.pointer().at.y()) - size / 2;
  }
  x += moves ? page.steps() : 0;
  page.number("left", x % width, "px");
  page.plot("left", x % width, "px");
  pixels = drawn(x, y, size, orange, page.dark());
  page.show(width, height, pixels);
}

} // namespace cookbook::live
