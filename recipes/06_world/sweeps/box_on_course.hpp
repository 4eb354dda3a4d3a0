#pragma once

/// \file
/// \brief When a box first touches another body on its way through a step.

#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "05_resolution/tunnelling/moving_corners.hpp"
#include "06_world/sweeps/ball_on_course.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace cookbook
{

// [box_look_out]
/// The direction from a box along which another shape is farthest away, and how far that is [m].
inline Direction<double> way_between(const Obb<double>& box, const Obb<double>& other)
{
  return box_gap(box, other);
}
inline Direction<double> way_between(const Obb<double>& box, const Sphere<double>& ball)
{
  const Direction<double> way = way_between(ball, box);
  return {-way.unit, way.length};
}
/// How far [m] a ball reaches from its centre, along any axis.
inline double reach_along(const Sphere<double>& ball, const Vector3<double>&)
{
  return ball.radius;
}
inline double reach_along(const Obb<double>& box, const Vector3<double>& axis)
{
  return box_radius(box, axis);
}
inline Direction<double> way_between(const Obb<double>& box, const Plane<double>& plane)
{
  const double above = signed_distance(plane, box.center);
  return {-plane.normal, above - reach_along(box, plane.normal)};
}

/// What a box and another shape see of each other along a direction n from the box to that: either
/// may carry n along as it turns, and the one for which the gap lasts longer is right.
template <class Shape>
BoxOutlook<double> box_outlook(
    const Obb<double>& box, const Passage<double>& moves, const Shape& other,
    const Passage<double>& passes, const Vector3<double>& n, double allowed, double touching)
{
  const BoxOutlook<double> of_box = corner_outlook<double>(
      moves, n, reach_along(box, n), moving_corners(other, passes), allowed, touching);
  const BoxOutlook<double> of_other = corner_outlook<double>(
      passes, -n, reach_along(other, n), moving_corners(box, moves), allowed, touching);
  return {
      {n, std::max(of_box.ahead.length, of_other.ahead.length)},
      of_box.closes && of_other.closes,
      std::max(of_box.lasts, of_other.lasts)};
}
/// A plane stays where it is.
inline BoxOutlook<double> box_outlook(
    const Obb<double>& box, const Passage<double>& moves, const Plane<double>& plane,
    Passage<double> passes, const Vector3<double>& n, double allowed, double touching)
{
  passes.center = box.center - signed_distance(plane, box.center) * plane.normal;
  const BoxOutlook<double> outlook = corner_outlook<double>(
      passes, plane.normal, 0, moving_corners(box, moves), allowed, touching);
  return {{n, outlook.ahead.length}, outlook.closes, outlook.lasts};
}
// [box_look_out]

// [box_touch]
/// When a box first touches another shape, from one moment [s] of a step to its end; where they
/// overlap already, when they are deeper in each other. With a slack [m] they may be as deep as
/// that, or by a little of it deeper than at first. The time of the answer is a share of the step.
struct BoxOnCourse
{
  const Course& box;
  const Course& other;
  double from;  ///< [s]
  double step;  ///< [s]
  double slack; ///< [m]

  /// How a body passes on from a time [s], as far as it would go in a whole step.
  Passage<double> passage(const Course& of, const RigidBody& pose, double time) const
  {
    return {
        pose.motion.center, step * of.velocity_at(time), step * step * of.pull.acceleration,
        step * of.spin};
  }
  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const BoxShape& box_shape, const Shape& other_shape) const
  {
    const Vector3<double> acceleration = box.pull.acceleration - other.pull.acceleration;
    const double fastest =
        (box.velocity_at(from) - other.velocity_at(from)).norm() + step * acceleration.norm();
    const double size = std::max(reach_of(box_shape), reach_of(other_shape));
    const Vector3<double> places = box.place_at(from).cwiseAbs() + other.place_at(from).cwiseAbs();
    const double touching = sweep_rounding<double>(places, {step * fastest, 0, 0}, size) +
                            1e-9 * thinness_of(box_shape);
    std::optional<double> allowed; // by how deep they are at the first look
    const auto look = [&](double share)
    {
      const double time = share * step;
      const RigidBody here = box.pose_at(time), there = other.pose_at(time);
      const auto at = placed(here, box_shape);
      const auto shape = placed(there, other_shape);
      const Direction<double> way = way_between(at, shape);
      if (!allowed)
      {
        allowed = std::max({0.0, slack, slack / 25 - way.length});
      }
      return box_outlook(
          at, passage(box, here, time), shape, passage(other, there, time), way.unit, *allowed,
          touching);
    };
    return advance_boxes(from / step, touching, look);
  }
  /// Only boxes.
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};
// [box_touch]

} // namespace cookbook
