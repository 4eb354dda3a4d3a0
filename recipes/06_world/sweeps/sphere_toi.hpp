#pragma once

/// \file
/// \brief When a sphere first touches another body within a step.

#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/shapes/gap_between.hpp"
#include "06_world/sweeps/body_sizes.hpp"
#include "06_world/sweeps/trajectory.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

// [placed_at]
/// A body's shape as it is at a time [s] of its course.
inline Obb<double> placed_at(const Trajectory& trajectory, double time, const BoxShape& box)
{
  return placed(trajectory.pose_at(time), box);
}
inline Sphere<double>
placed_at(const Trajectory& trajectory, double time, const SphereShape& sphere)
{
  return {trajectory.place_at(time), sphere.radius};
}
inline Placed<ConvexShape>
placed_at(const Trajectory& trajectory, double time, const ConvexShape& shape)
{
  return placed(trajectory.pose_at(time), shape);
}
/// A plane stays where it is.
inline Plane<double> placed_at(const Trajectory& trajectory, double, const PlaneShape& plane)
{
  return placed(*trajectory.of, plane);
}
// [placed_at]

// [toi_event]
/// When a ball first gets deeper into another shape than is allowed, from one moment [s] of a step
/// to its end. The time of the answer is a fraction of the step.
struct SphereToi
{
  const Trajectory& sphere;
  const Trajectory& other;
  double from;    ///< [s]
  double step;    ///< [s]
  double allowed; ///< [m]

  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const SphereShape& ball_shape, const Shape& other_shape) const
  {
    const auto way_at = [&](double time)
    { return gap_of(placed_at(sphere, time, ball_shape), placed_at(other, time, other_shape)); };
    const Vector3<double> acceleration = sphere.external.acceleration - other.external.acceleration;
    const auto query = [&](double fraction)
    {
      const double time = fraction * step;
      Direction<double> gap = way_at(time);
      gap.length += allowed;
      const Vector3<double> closing_velocity =
          sphere.velocity_at(time) - other.velocity_of(sphere.place_at(time), time);
      return GapState<double>{
          gap, step * closing_velocity.dot(gap.unit), step * step * acceleration.dot(gap.unit)};
    };
    // How much the way of the ball bends, seen from the other body: it falls, and that one turns.
    const Vector3<double> separation = sphere.place_at(from) - other.place_at(from);
    const double max_acceleration = acceleration.norm(), rotation = other.spin.norm();
    const double fastest =
        (sphere.velocity_at(from) - other.velocity_at(from)).norm() + step * max_acceleration;
    const double max_displacement = separation.norm() + step * fastest;
    const double acceleration_bound =
        step * step *
        (max_acceleration +
         (rotation > 0 ? rotation * (2 * fastest + rotation * max_displacement) : 0));
    const double size = std::max(ball_shape.radius, bounding_radius_of(other_shape));
    const double rounding = sweep_rounding<double>(separation, {step * fastest, 0, 0}, size);
    return first_touch<double>(from / step, acceleration_bound, rounding, query);
  }
  /// Of two other shapes neither is a ball.
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};
// [toi_event]

} // namespace cookbook
