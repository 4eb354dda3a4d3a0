#pragma once

/// \file
/// \brief The scene of the page about pictures.

#include "02_primitives/picture/picture.hpp"
#include "common/math/rotation.hpp"

#include <array>

namespace cookbook
{

/// Draws the page's scene: bricks, a ball, their shadows and an arrow.
inline void draw_scene(Picture& picture, const Palette& palette)
{
  const Camera<double> camera = orbit_camera({{0.1, 0.5, 0}, 4.6, 0.45, 0.4, 0.65}, 640, 400);
  const Obb<double> floor = floor_at(0, 3);
  const Matrix3<double> upright = Matrix3<double>::Identity();
  const std::array<Obb<double>, 4> bricks{
      {{{-0.9, 0.25, -0.2}, upright, {0.5, 0.25, 0.3}},
       {{0.15, 0.25, -0.2}, upright, {0.5, 0.25, 0.3}},
       {{-0.4, 0.75, -0.2}, upright, {0.5, 0.25, 0.3}},
       {{-0.35, 1.31, -0.2}, rational_rotation<double>(9, 0, 2, 1), {0.3, 0.3, 0.3}}}};
  const Sphere<double> ball{{0.9, 0.4, 0.6}, 0.4};
  draw_ground(picture, camera, floor, palette);
  for (std::size_t i = 0; i < bricks.size(); ++i)
  {
    draw_shadow(picture, camera, floor, bricks[i], palette.shadow);
    draw_box(picture, camera, bricks[i], i == 3 ? palette.b : palette.a);
  }
  draw_shadow(picture, camera, floor, ball, palette.shadow);
  draw_sphere(picture, camera, ball, rational_rotation<double>(5, 1, 2, 1), palette.b);
  draw_arrow(picture, camera, {0.9, 0, 0.6}, {0, 1.4, 0}, palette.overlap, 2, Cover::none);
}

} // namespace cookbook
