#pragma once

/// \file
/// \brief When a ball first touches another body on its way through a step.

#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/sweeps/body_sizes.hpp"
#include "06_world/sweeps/course.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

// [look_out]
/// The direction from a ball to the nearest point of another shape, and how far that is [m].
inline Direction<double> way_between(const Sphere<double>& ball, const Sphere<double>& other)
{
  const Direction<double> centers = normalize<double>(other.center - ball.center);
  return {centers.unit, centers.length - ball.radius - other.radius};
}
inline Direction<double> way_between(const Sphere<double>& ball, const Plane<double>& plane)
{
  return {-plane.normal, signed_distance(plane, ball.center) - ball.radius};
}
inline Direction<double> way_between(const Sphere<double>& ball, const Obb<double>& box)
{
  const Vector3<double> local = box_coordinates(box, ball.center);
  const Direction<double> way = direction_to_box(local, box.axes, box.half_extents);
  return {way.unit, way.length - ball.radius};
}
// [look_out]

// [placed_at]
/// A body's shape as it is at a time [s] of its course.
inline Obb<double> placed_at(const Course& course, double time, const BoxShape& box)
{
  return placed(course.pose_at(time), box);
}
inline Sphere<double> placed_at(const Course& course, double time, const SphereShape& ball)
{
  return {course.place_at(time), ball.radius};
}
/// A plane stays where it is.
inline Plane<double> placed_at(const Course& course, double, const PlaneShape& plane)
{
  return placed(*course.of, plane);
}
// [placed_at]

// [course_touch]
/// When a ball first gets deeper into another shape than is allowed, from one moment [s] of a step
/// to its end. The time of the answer is a share of the step.
struct BallOnCourse
{
  const Course& ball;
  const Course& other;
  double from;    ///< [s]
  double step;    ///< [s]
  double allowed; ///< [m]

  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const SphereShape& ball_shape, const Shape& other_shape) const
  {
    const auto way_at = [&](double time)
    { return way_between(placed_at(ball, time, ball_shape), placed_at(other, time, other_shape)); };
    const Vector3<double> acceleration = ball.pull.acceleration - other.pull.acceleration;
    const auto look = [&](double share)
    {
      const double time = share * step;
      Direction<double> ahead = way_at(time);
      ahead.length += allowed;
      const Vector3<double> passing =
          ball.velocity_at(time) - other.velocity_of(ball.place_at(time), time);
      return Outlook<double>{
          ahead, step * passing.dot(ahead.unit), step * step * acceleration.dot(ahead.unit)};
    };
    // How much the way of the ball bends, seen from the other body: it falls, and that one turns.
    const Vector3<double> apart = ball.place_at(from) - other.place_at(from);
    const double most_pull = acceleration.norm(), turn = other.spin.norm();
    const double fastest =
        (ball.velocity_at(from) - other.velocity_at(from)).norm() + step * most_pull;
    const double farthest = apart.norm() + step * fastest;
    const double bend =
        step * step * (most_pull + (turn > 0 ? turn * (2 * fastest + turn * farthest) : 0));
    const double size = std::max(ball_shape.radius, reach_of(other_shape));
    const double rounding = sweep_rounding<double>(apart, {step * fastest, 0, 0}, size);
    return first_touch<double>(from / step, bend, rounding, look);
  }
  /// Of two other shapes neither is a ball.
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};
// [course_touch]

} // namespace cookbook
