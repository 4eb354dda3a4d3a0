/// \file
/// \brief Counts pixels against closed forms, compares depths with a raycast, and draws a scene.

#include "02_primitives/picture/picture.hpp"
#include "02_primitives/casts/casts.hpp"
#include "02_primitives/picture/trial/picture_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

namespace
{

using namespace cookbook;

const Sphere<double> ball{{0, 0, 0}, 1};
constexpr Colour red{200, 0, 0};

/// A camera 5 m before the origin, whose 400 by 400 pixels see 10 m there.
Camera<double> straight_camera()
{
  return {
      look_at<double>({0, 0, 5}, {0, 0, 0}, {0, 1, 0}),
      perspective<double>(std::numbers::pi / 2, 1, 0.1, 100).value(),
      {400, 400}};
}

/// How many pixels something covers.
long covered_pixels(const Picture& picture)
{
  return std::count_if(picture.depth.begin(), picture.depth.end(), [](float d) { return d < 1; });
}

/// How many pixels the shadow of a cube of 1 m has, seen from above at 100 pixels a metre.
long shadow_pixels()
{
  const Camera<double> above{
      look_at<double>({0, 5, 0}, {0, 0, 0}, {0, 0, -1}),
      orthographic<double>(6, 6, 0.1, 10).value(),
      {600, 600}};
  const Obb<double> cube{{0, 0.5, 0}, Matrix3<double>::Identity(), {0.5, 0.5, 0.5}};
  Picture picture = make_picture(600, 600);
  draw_ground(picture, above, floor_at(0, 3), light_palette(), 0);
  draw_shadow(picture, above, floor_at(0, 3), cube, red);
  return std::count(picture.pixels.begin(), picture.pixels.end(), to_pixel(red));
}

void print_areas()
{
  Picture face = make_picture(400, 400), disc = face;
  draw_box(face, straight_camera(), {{0, 0, -1}, Matrix3<double>::Identity(), {1, 1, 1}}, red);
  draw_sphere(disc, straight_camera(), ball, Matrix3<double>::Identity(), red);
  const double cone = std::numbers::pi * 200 * 200 / (5 * 5 - 1);
  Table table({"what", "pixels", "closed form", "from"});
  table.row({"a face of 2 m, 5 m ahead", std::to_string(covered_pixels(face)), "6400", "80²"});
  table.row(
      {"a ball of radius 1 m, 5 m ahead", std::to_string(covered_pixels(disc)),
       std::to_string(std::lround(cone)), "pi 200² / (5² - 1²)"});
  table.row(
      {"the shadow of a cube of 1 m", std::to_string(shadow_pixels()), "20500",
       "100² (1 + 0.6 + 0.45)"});
  std::cout << table.text() << '\n';
}

void print_depths()
{
  const Camera<double> camera = straight_camera();
  Picture picture = make_picture(400, 400);
  draw_sphere(picture, camera, ball, Matrix3<double>::Identity(), red);
  Table table({"pixel", "t of the raycast [m]", "t from the depth [m]"});
  for (const int x : {200, 220, 235, 240})
  {
    const Vector2<double> pixel(x + 0.5, 200.5);
    const Ray<double> ray = picking_ray(camera, pixel);
    const auto hit = cast(ray, ball);
    const double depth =
        static_cast<double>(picture.depth[row_start(picture, 200) + static_cast<std::size_t>(x)]);
    const auto point = unproject<double>(camera, {pixel, depth});
    table.row(
        {std::to_string(x) + ", 200", hit ? number(hit->t) : "none",
         depth < 1 && point ? number((*point - ray.origin).norm()) : "none"});
  }
  std::cout << table.text() << '\n';
}

void print_hashes()
{
  constexpr std::string_view digits = "0123456789abcdef";
  for (const int samples : {1, 2})
  {
    Picture picture = make_picture(640, 400, samples);
    clear(picture, light_palette());
    draw_scene(picture, light_palette());
    std::uint64_t hash = picture_hash(shown(picture));
    std::string text;
    for (int i = 0; i < 16; ++i, hash <<= 4)
    {
      text += digits[hash >> 60];
    }
    std::cout << "the scene with " << samples * samples << " samples a pixel: " << text << '\n';
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "picture",
      .summary = "Counts pixels against closed forms, compares depths with a raycast, draws."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_areas();
        print_depths();
        print_hashes();
        save_figure(given, "picture.svg", plot::document("picture", scene_panel()));
        save_figure(given, "picture_depth.svg", depth_figure());
      });
}
