#pragma once

/// \file
/// \brief The time of impact (TOI) of two bodies within a step, by conservative advancement.

#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/sweeps/body_sizes.hpp"
#include "06_world/sweeps/moving_support.hpp"
#include "06_world/sweeps/trajectory.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace cookbook
{

// [gap_approach]
/// What two shapes see of each other along a direction n from the first to the other: either may
/// carry n along as it turns, and the one for which the gap lasts longer is right.
template <class Shape, class Other>
BoxApproach<double> gap_approach(
    const Shape& shape, const LinearMotion<double>& moves, const Other& other,
    const LinearMotion<double>& passes, const Vector3<double>& n, double allowed, double tolerance)
{
  const BoxApproach<double> of_first = corner_approach(
      moves, n, projected_radius(shape, n), moving_corners(other, passes), allowed, tolerance);
  const BoxApproach<double> of_other = corner_approach(
      passes, Vector3<double>(-n), projected_radius(other, -n), moving_corners(shape, moves),
      allowed, tolerance);
  return {
      {n, std::max(of_first.gap.length, of_other.gap.length)},
      of_first.closes && of_other.closes,
      std::max(of_first.safe_time, of_other.safe_time)};
}
/// A plane stays where it is.
template <class Shape>
BoxApproach<double> gap_approach(
    const Shape& shape, const LinearMotion<double>& moves, const Plane<double>& plane,
    LinearMotion<double> passes, const Vector3<double>& n, double allowed, double tolerance)
{
  passes.center = moves.center - signed_distance(plane, moves.center) * plane.normal;
  const BoxApproach<double> approach =
      corner_approach(passes, plane.normal, 0.0, moving_corners(shape, moves), allowed, tolerance);
  return {{n, approach.gap.length}, approach.closes, approach.safe_time};
}
// [gap_approach]

// [time_of_impact]
/// Where two bodies are too deep in each other as a search begins, they may get deeper by one of so
/// many parts of what is allowed: 0.2 % of the size of the thinner one.
inline constexpr double deeper_parts = 25;

/// How far [m] the gap of two shapes may be off that is found by support functions alone.
template <class Shape, class Other>
double gap_rounding(const Shape& shape, const Other& other)
{
  constexpr bool iterates =
      std::is_same_v<Shape, ConvexShape> || std::is_same_v<Other, ConvexShape>;
  return iterates ? convex_tolerance * (bounding_radius_of(shape) + bounding_radius_of(other)) : 0;
}

/// When two bodies first get deeper into each other than is allowed, from one moment [s] of a step
/// to its end. The time of the answer is a fraction of the step, its normal from the first to the
/// other.
struct TimeOfImpact
{
  const Trajectory& first;
  const Trajectory& other;
  double from;    ///< [s]
  double step;    ///< [s]
  double allowed; ///< [m]

  Vector3<double> acceleration() const
  {
    return first.external.acceleration - other.external.acceleration;
  }
  /// The most [m/s] that the two centres may close at.
  double fastest() const
  {
    return (first.velocity_at(from) - other.velocity_at(from)).norm() +
           step * acceleration().norm();
  }
  /// How a body passes on from a time [s], as far as it would go in a whole step.
  LinearMotion<double> passage(const Trajectory& of, double time) const
  {
    return {
        of.place_at(time), step * of.velocity_at(time), step * step * of.external.acceleration,
        step * of.spin};
  }

  /// Of a sphere: its centre has no turning, so that its gap closes at a known rate, and is met to
  /// the last bit.
  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const SphereShape& sphere, const Shape& other_shape) const
  {
    const auto query = [&](double fraction)
    {
      const double time = fraction * step;
      Direction<double> gap = gap_of(
          Sphere<double>{first.place_at(time), sphere.radius},
          placed(other.pose_at(time), other_shape));
      gap.length += allowed;
      const Vector3<double> closing_velocity =
          first.velocity_at(time) - other.velocity_of(first.place_at(time), time);
      return GapState<double>{
          gap, step * closing_velocity.dot(gap.unit), step * step * acceleration().dot(gap.unit)};
    };
    // How much the path of the sphere bends, seen from the other body: it falls, and that one
    // turns.
    const Vector3<double> separation = first.place_at(from) - other.place_at(from);
    const double max_acceleration = acceleration().norm(), rotation = other.spin.norm();
    const double max_displacement = separation.norm() + step * fastest();
    const double acceleration_bound =
        step * step *
        (max_acceleration +
         (rotation > 0 ? rotation * (2 * fastest() + rotation * max_displacement) : 0));
    const double size = std::max(sphere.radius, bounding_radius_of(other_shape));
    const double rounding = sweep_rounding<double>(separation, {step * fastest(), 0, 0}, size);
    return first_touch<double>(from / step, acceleration_bound, rounding, query);
  }

  /// Of any other shape. Where both overlap already, it is when they are deeper in each other by a
  /// little of what is allowed.
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape& shape, const Other& other_shape) const
  {
    const double size = std::max(bounding_radius_of(shape), bounding_radius_of(other_shape));
    const Vector3<double> places =
        first.place_at(from).cwiseAbs() + other.place_at(from).cwiseAbs();
    const double tolerance = sweep_rounding<double>(places, {step * fastest(), 0, 0}, size) +
                             length_rounding * inner_radius_of(shape) +
                             gap_rounding(shape, other_shape);
    std::optional<double> depth; // that is allowed, by how deep they are at the first look
    const auto query = [&](double fraction)
    {
      const double time = fraction * step;
      const auto here = placed(first.pose_at(time), shape);
      const auto there = placed(other.pose_at(time), other_shape);
      const Direction<double> gap = gap_of(here, there);
      if (!depth)
      {
        depth = std::max({0.0, allowed, allowed / deeper_parts - gap.length});
      }
      return gap_approach(
          here, passage(first, time), there, passage(other, time), gap.unit, *depth, tolerance);
    };
    return advance_boxes(from / step, tolerance, query);
  }

  /// Of a plane, which no push moves: as the other body sees it.
  template <class Other>
  std::optional<SweptHit<double>> operator()(const PlaneShape& plane, const Other& shape) const
  {
    auto hit = TimeOfImpact{other, first, from, step, allowed}(shape, plane);
    return hit ? std::optional(SweptHit<double>{hit->time, -hit->normal}) : std::nullopt;
  }
  /// Two planes are fixed, and never touch anew.
  std::optional<SweptHit<double>> operator()(const PlaneShape&, const PlaneShape&) const
  {
    return std::nullopt;
  }
};
// [time_of_impact]

} // namespace cookbook
