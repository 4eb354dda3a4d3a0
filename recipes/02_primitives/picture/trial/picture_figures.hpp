#pragma once

/// \file
/// \brief The picture's figures: a scene as squares, and depths along a row.

#include "02_primitives/picture/trial/edges_figure.hpp"
#include "02_primitives/picture/trial/picture_scene.hpp"
#include "02_primitives/plain_picture/plain_picture.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/plot/svg.hpp"

#include <map>
#include <string>
#include <vector>

namespace cookbook
{

/// The squares of all pixels of one colour as the data of a path; `side` [pixels of the figure].
inline std::string squares_of(const Picture& picture, std::uint32_t colour, int side)
{
  std::string data;
  for (int y = 0; y < picture.height; ++y)
  {
    for (int x = 0; x < picture.width; ++x)
    {
      const auto is_it = [&](int at)
      {
        return at < picture.width &&
               picture.pixels[row_start(picture, y) + static_cast<std::size_t>(at)] == colour;
      };
      int last = x;
      while (is_it(last))
      {
        ++last;
      }
      if (last > x)
      {
        const std::string width = std::to_string((last - x) * side), high = std::to_string(side);
        data += 'M' + std::to_string(x * side) + ',' + std::to_string(y * side) + 'h' + width +
                'v' + high + "h-" + width + 'z';
        x = last;
      }
    }
  }
  return data;
}

/// A colour as a style sheet has it.
inline std::string css_colour(const Colour& c)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t byte : {c.r, c.g, c.b})
  {
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

/// The scene, 120 by 75 pixels, each a square; floor, grid and shadow follow light and dark.
inline plot::Panel scene_panel()
{
  constexpr int side = 5;
  const Palette palette = light_palette();
  const std::uint32_t sky = to_pixel({255, 0, 255}), ground = to_pixel(palette.ground);
  Picture picture = make_picture(120, 75);
  clear(picture, to_colour(sky));
  draw_scene(picture, palette);
  const auto shaded = [&palette](const Colour& under)
  { return to_pixel(mixed(under, palette.shadow, palette.shadow.a)); };
  std::map<std::uint32_t, std::string> squares;
  for (const std::uint32_t pixel : picture.pixels)
  {
    squares.try_emplace(pixel, "");
  }
  std::string body;
  for (auto& [pixel, data] : squares)
  {
    data = squares_of(picture, pixel, side);
    const bool in_shadow = pixel == shaded(palette.ground) || pixel == shaded(palette.grid);
    body += pixel == sky      ? ""
            : pixel == ground ? plot::svg::filled(data, plot::Ink::faint, 0.4)
            : pixel == to_pixel(palette.grid)
                ? plot::svg::filled(data, plot::Ink::faint, 1)
                : plot::svg::element(
                      "path", {{"d", data},
                               {"fill", in_shadow ? "#000000" : css_colour(to_colour(pixel))},
                               {"fill-opacity", in_shadow ? "0.35" : "1"}});
  }
  return {
      120.0 * side,
      75.0 * side,
      "",
      "Bricks, a turned cube and a ball with a red arrow stand on a floor with a grid and shadows, "
      "in a picture of 120 by 75 square pixels.",
      "<g shape-rendering=\"crispEdges\">" + body + "</g>",
      {}};
}

/// Two triangles that cross, and the depth of both along the middle row.
inline std::string depth_figure()
{
  const Vector3<double> a(2, 1, 0.2), b(46, 6, 0.8), c(2, 11, 0.2);
  const Vector3<double> d(46, 1, 0.2), e(46, 11, 0.2), f(2, 6, 0.8);
  const Colour blue{0, 0, 1}, orange{1, 0, 0};
  Picture picture = make_picture(48, 12);
  fill_triangle(picture, a, b, c, blue);
  fill_triangle(picture, d, e, f, orange);
  plot::Figure2d seen("picture_seen", "what is seen", {{-1, -12.5}, {49, 0.5}, 560});
  seen.grid(1);
  for (int y = 0; y < 12; ++y)
  {
    for (int x = 0; x < 48; ++x)
    {
      const std::uint32_t pixel =
          picture.pixels[row_start(picture, y) + static_cast<std::size_t>(x)];
      if (pixel != to_pixel({0, 0, 0}))
      {
        seen.region(square(x, y), pixel == to_pixel(blue) ? plot::Ink::a : plot::Ink::b);
      }
    }
  }
  const auto up = [](const Vector3<double>& p) { return Eigen::Vector2d(p.x(), -p.y()); };
  seen.polyline({up(b), up(a), up(c), up(b)}, plot::Ink::a, plot::Stroke::dashed);
  seen.polyline({up(f), up(d), up(e), up(f)}, plot::Ink::b, plot::Stroke::dashed);
  plot::Figure2d depths(
      "picture_depths", "depth along the middle row", {{-1, -1}, {49, 10.5}, 560});
  const auto at = [](double x, double depth) { return Eigen::Vector2d(x, depth * 10); };
  depths.segment({0, 0}, {48, 0}, plot::Ink::muted);
  depths.segment(at(24, 0.5), at(46, 0.8), plot::Ink::a, plot::Stroke::dashed);
  depths.segment(at(24, 0.5), at(2, 0.8), plot::Ink::b, plot::Stroke::dashed);
  depths.segment(at(2, 0.2), at(24, 0.5), plot::Ink::a, plot::Stroke::solid, 3);
  depths.segment(at(46, 0.2), at(24, 0.5), plot::Ink::b, plot::Stroke::solid, 3);
  depths.label(at(8, 0.28), "A is nearer", plot::Side::below_right, plot::Ink::a);
  depths.label(at(40, 0.28), "B is nearer", plot::Side::below_left, plot::Ink::b);
  depths.label(at(42, 0.74), "hidden", plot::Side::above_left, plot::Ink::a);
  depths.label(at(6, 0.74), "hidden", plot::Side::above_right, plot::Ink::b);
  return plot::Grid("picture_depth", "", 1)
      .describe("Two triangles cross; at each pixel the nearer one is seen.")
      .add(seen)
      .add(depths)
      .svg();
}

} // namespace cookbook
