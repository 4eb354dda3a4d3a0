#pragma once

/// \file
/// \brief When a box first touches another body within a step.

#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "05_resolution/tunnelling/moving_corners.hpp"
#include "06_world/sweeps/sphere_toi.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace cookbook
{

// [box_direction]
/// How far [m] a sphere reaches from its centre, along any axis.
inline double projected_radius(const Sphere<double>& sphere, const Vector3<double>&)
{
  return sphere.radius;
}
inline double projected_radius(const Obb<double>& box, const Vector3<double>& axis)
{
  return box_radius(box, axis);
}

/// What a box and another shape see of each other along a direction n from the box to that: either
/// may carry n along as it turns, and the one for which the gap lasts longer is right.
template <class Shape>
BoxApproach<double> box_approach(
    const Obb<double>& box, const LinearMotion<double>& moves, const Shape& other,
    const LinearMotion<double>& passes, const Vector3<double>& n, double allowed, double tolerance)
{
  const BoxApproach<double> of_box = corner_approach<double>(
      moves, n, projected_radius(box, n), moving_corners(other, passes), allowed, tolerance);
  const BoxApproach<double> of_other = corner_approach<double>(
      passes, -n, projected_radius(other, n), moving_corners(box, moves), allowed, tolerance);
  return {
      {n, std::max(of_box.gap.length, of_other.gap.length)},
      of_box.closes && of_other.closes,
      std::max(of_box.safe_time, of_other.safe_time)};
}
/// A plane stays where it is.
inline BoxApproach<double> box_approach(
    const Obb<double>& box, const LinearMotion<double>& moves, const Plane<double>& plane,
    LinearMotion<double> passes, const Vector3<double>& n, double allowed, double tolerance)
{
  passes.center = box.center - signed_distance(plane, box.center) * plane.normal;
  const BoxApproach<double> approach = corner_approach<double>(
      passes, plane.normal, 0, moving_corners(box, moves), allowed, tolerance);
  return {{n, approach.gap.length}, approach.closes, approach.safe_time};
}
// [box_direction]

// [box_toi]
/// When a box first touches another shape, from one moment [s] of a step to its end; where they
/// overlap already, when they are deeper in each other. With an allowed overlap [m] they may be as
/// deep as that, or by a little of it deeper than at first. The time of the answer is a fraction of
/// the step.
struct BoxToi
{
  const Trajectory& box;
  const Trajectory& other;
  double from;            ///< [s]
  double step;            ///< [s]
  double allowed_overlap; ///< [m]

  /// How a body passes on from a time [s], as far as it would go in a whole step.
  LinearMotion<double> passage(const Trajectory& of, const RigidBody& pose, double time) const
  {
    return {
        pose.motion.center, step * of.velocity_at(time), step * step * of.external.acceleration,
        step * of.spin};
  }
  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const BoxShape& box_shape, const Shape& other_shape) const
  {
    const Vector3<double> acceleration = box.external.acceleration - other.external.acceleration;
    const double fastest =
        (box.velocity_at(from) - other.velocity_at(from)).norm() + step * acceleration.norm();
    const double size = std::max(bounding_radius_of(box_shape), bounding_radius_of(other_shape));
    const Vector3<double> places = box.place_at(from).cwiseAbs() + other.place_at(from).cwiseAbs();
    const double tolerance = sweep_rounding<double>(places, {step * fastest, 0, 0}, size) +
                             1e-9 * inner_radius_of(box_shape);
    std::optional<double> allowed; // by how deep they are at the first look
    const auto query = [&](double fraction)
    {
      const double time = fraction * step;
      const RigidBody here = box.pose_at(time), there = other.pose_at(time);
      const auto at = placed(here, box_shape);
      const auto shape = placed(there, other_shape);
      const Direction<double> direction = gap_of(at, shape);
      if (!allowed)
      {
        allowed = std::max({0.0, allowed_overlap, allowed_overlap / 25 - direction.length});
      }
      return box_approach(
          at, passage(box, here, time), shape, passage(other, there, time), direction.unit,
          *allowed, tolerance);
    };
    return advance_boxes(from / step, tolerance, query);
  }
  /// Only boxes, and no other convex shapes.
  std::optional<SweptHit<double>> operator()(const BoxShape&, const ConvexShape&) const
  {
    return std::nullopt;
  }
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};
// [box_toi]

} // namespace cookbook
