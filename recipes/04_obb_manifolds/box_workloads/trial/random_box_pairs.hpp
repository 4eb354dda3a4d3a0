#pragma once

/// \file
/// \brief Kinds of pairs of boxes, each drawn at random: what is hard about two boxes.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"

#include <algorithm>

namespace cookbook
{

/// Two boxes of any size within a factor of four, turned anyhow, centres up to `range` [m] apart
/// along each axis of the world.
inline BoxPair<double> random_boxes(BoxDraw& draw, double range)
{
  const Matrix3<double> axes_a = draw.rotation(), axes_b = draw.rotation();
  const Vector3<double> half_a = draw.vector(0.25, 1), half_b = draw.vector(0.25, 1);
  return {{{0, 0, 0}, axes_a, half_a}, {draw.vector(-range, range), axes_b, half_b}};
}

/// The same with axes that differ by a turn of 2⁻²⁶ to 2⁻⁷ rad, and by their labels.
inline BoxPair<double> near_parallel_boxes(BoxDraw& draw)
{
  BoxPair<double> pair = random_boxes(draw, 1.4);
  const double angle = draw.octaves(0x1p-26, 19);
  pair.second.axes = BoxDraw::tilt(angle, draw.direction()) * pair.first.axes;
  return anywhere(draw, pair);
}

// [resting]
/// B's face on A's, turned about the height anyhow, tilted by up to 1e-4 rad, its middle above A's
/// face; `flat` is the largest fraction of the longest half extent that the height has.
inline BoxPair<double> resting_boxes(BoxDraw& draw, double flat, double deepest)
{
  Vector3<double> half_a = draw.vector(0.35, 1), half_b = draw.vector(0.35, 1);
  if (flat < 1)
  {
    half_a.y() = draw.between(flat / 2, flat) * std::max(half_a.x(), half_a.z());
    half_b.y() = draw.between(flat / 2, flat) * std::max(half_b.x(), half_b.z());
  }
  const double w = draw.between(-1, 1);
  const Matrix3<double> yaw = quaternion_rotation(w, {0, draw.between(-1, 1), 0});
  const double angle = draw.between(0, 1e-4);
  const Vector3<double> level =
      normalize<double>(draw.vector(-1, 1).cwiseProduct(Vector3<double>(1, 0, 1))).unit;
  const Matrix3<double> axes_b = BoxDraw::tilt(angle, level) * yaw;
  const double size = std::max(half_a.maxCoeff(), half_b.maxCoeff());
  Vector3<double> center_b = draw.vector(-1, 1).cwiseProduct(half_a);
  center_b.y() =
      half_a.y() + axes_b.row(1).cwiseAbs().dot(half_b) - draw.between(0.001, deepest) * size;
  return anywhere(
      draw, {{{0, 0, 0}, Matrix3<double>::Identity(), half_a}, {center_b, axes_b, half_b}});
}
// [resting]

// [edge_edge]
/// An edge of B across an edge of A at 33° to 90°, both ridges leaning by up to 22° from upright.
inline BoxPair<double> crossed_edges(BoxDraw& draw)
{
  const auto ridge = [&](double yaw) -> Obb<double>
  {
    // A turn by twice the angle whose tangent is given, 23° to 62°: the edge along x on top.
    const Matrix3<double> lean = quaternion_rotation(1, {draw.between(0.2, 0.6), 0, 0});
    const Matrix3<double> turn = quaternion_rotation(1, {0, yaw, 0});
    return {{0, 0, 0}, turn * lean, draw.vector(0.35, 1)};
  };
  const Obb<double> a = ridge(0);
  Obb<double> b = ridge(draw.side() * draw.between(0.3, 1));
  const auto edge = [&](const Obb<double>& box, double up) -> Vector3<double>
  {
    const Vector3<double> fraction(draw.between(-0.8, 0.8), up, -up);
    return box.axes * fraction.cwiseProduct(box.half_extents);
  };
  const double size = std::max(a.half_extents.maxCoeff(), b.half_extents.maxCoeff());
  const Vector3<double> sunk(0, draw.between(0.001, 0.01) * size, 0);
  const Vector3<double> on_a = edge(a, 1);
  b.center = on_a - sunk - edge(b, -1);
  return anywhere(draw, {a, b});
}
// [edge_edge]

/// Cubes on a grid of 1/64 m that touch: every number is exact, and the overlap is zero.
inline BoxPair<double> touching_boxes(BoxDraw& draw)
{
  const auto on_grid = [&](int low, int count) -> Vector3<double>
  {
    const int x = draw.whole(count), y = draw.whole(count);
    return Vector3<double>(low + x, low + y, low + draw.whole(count)) / 64;
  };
  const Matrix3<double> upright = Matrix3<double>::Identity();
  const Obb<double> a{on_grid(-64, 129), upright, on_grid(16, 49)};
  Obb<double> b{on_grid(-32, 65), upright, on_grid(16, 49)};
  const int axis = draw.whole(3);
  b.center[axis] = draw.side() * (a.half_extents[axis] + b.half_extents[axis]);
  b.center += a.center;
  return {relabelled(a, draw.whole(24)), relabelled(b, draw.whole(24))};
}

/// Half extents of 2⁻¹⁰ to 1 m, each on its own.
inline Vector3<double> needle(BoxDraw& draw)
{
  const double x = draw.octaves(0x1p-10, 10), y = draw.octaves(0x1p-10, 10);
  return {x, y, draw.octaves(0x1p-10, 10)};
}

/// One of six: in one place, touching exactly, contained, parallel, flush, needles.
inline BoxPair<double> degenerate_boxes(BoxDraw& draw)
{
  BoxPair<double> pair = random_boxes(draw, 1);
  auto& [a, b] = pair;
  switch (draw.whole(6))
  {
  case 0:
    b = a;
    break;
  case 1:
    return touching_boxes(draw);
  case 2:
    b.center = a.axes * draw.vector(-0.7, 0.7).cwiseProduct(a.half_extents);
    b.half_extents *= 0.05;
    break;
  case 3:
    b.axes = a.axes;
    break;
  case 4:
    b = {draw.between(-2, 2) * a.axes.col(0) * a.half_extents.x(), a.axes, a.half_extents};
    break;
  default:
    a.half_extents = needle(draw);
    b = {draw.vector(-0.3, 0.3), b.axes, needle(draw)};
  }
  return anywhere(draw, pair);
}

} // namespace cookbook
