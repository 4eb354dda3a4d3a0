#pragma once

/// \file
/// \brief How a body of a world goes through a step, and when a ball first touches another on the
/// way.

#include "05_resolution/contacts/narrow_phase.hpp"
#include "01_math/turning/rotation_by.hpp"
#include "05_resolution/tunnelling/swept_sphere.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

// [course]
/// A body's way through a step, or through what is left of it: the centre along a parabola, or
/// straight; the body turns steadily.
struct Course
{
  RigidBody start;              ///< the body as this course begins
  double since;                 ///< [s], of the step, when it begins
  Vector3<double> velocity;     ///< [m/s], at which the centre sets out
  Vector3<double> acceleration; ///< [m/s²], of the centre
  Vector3<double> spin;         ///< [rad/s], world; zero for a ball, whose turning changes nothing

  /// The velocity [m/s] of the centre at a time [s] of the step.
  Vector3<double> velocity_at(double time) const
  {
    return velocity + (time - since) * acceleration;
  }
  /// The place [m] of the centre at that time.
  Vector3<double> place_at(double time) const
  {
    return start.position + (time - since) * (velocity + (time - since) / 2 * acceleration);
  }
  /// The velocity [m/s] at that time of what the body carries along at a place [m].
  Vector3<double> velocity_of(const Vector3<double>& place, double time) const
  {
    return velocity_at(time) + spin.cross(place - place_at(time));
  }
  /// The pose of the body at that time; its motion is still that of the start.
  RigidBody pose_at(double time) const
  {
    RigidBody body = start;
    body.position = place_at(time);
    if (!spin.isZero(0))
    {
      const Vector3<double> turn = (time - since) * spin;
      body.orientation = (rotation_by<double>(turn) * start.orientation).normalized();
      update_axes(body);
    }
    return body;
  }
};

/// The steady spin [rad/s] that turns a body from one pose to another in a time [s].
inline Vector3<double> spin_between(const RigidBody& from, const RigidBody& to, double time)
{
  if (from.round || !(time > 0))
  {
    return Vector3<double>::Zero();
  }
  return turn_between<double>(from.orientation, to.orientation) / time;
}

/// The course of a body from one pose to another in a step [s], straight.
inline Course straight_course(const RigidBody& from, const RigidBody& to, double step)
{
  const Vector3<double> none = Vector3<double>::Zero();
  return {from, 0, (to.position - from.position) / step, none, spin_between(from, to, step)};
}

/// The course of a body that falls freely for a step [s], to a pose at its end.
inline Course falling_course(
    const RigidBody& from, const RigidBody& to, double step, const Vector3<double>& gravity)
{
  return {from, 0, from.velocity, gravity, spin_between(from, to, step)};
}

/// Takes out of the course of a ball what leads along a normal into the body that it leans on.
inline void hold_back(Course& course, const Course& other, const Vector3<double>& normal)
{
  const auto inwards = [&](const Vector3<double>& v) -> Vector3<double>
  { return std::max(0.0, v.dot(normal)) * normal; };
  course.velocity -=
      inwards(course.velocity - other.velocity_of(course.start.position, course.since));
  course.acceleration -= inwards(course.acceleration);
}
// [course]

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

/// How far [m] a shape reaches from its centre.
inline double reach_of(const SphereShape& ball)
{
  return ball.radius;
}
inline double reach_of(const BoxShape& box)
{
  return box.half_extents.norm();
}
inline double reach_of(const PlaneShape&)
{
  return 0;
}
// [look_out]

// [course_touch]
/// When a ball first touches another shape, from one moment [s] of a step to its end; or, with a
/// slack [m], when it is deeper in that shape than at first by more than that. The time of the
/// answer is a share of the step.
struct TouchOnCourse
{
  const Course& ball;
  const Course& other;
  double from;  ///< [s]
  double step;  ///< [s]
  double slack; ///< [m]

  template <class Shape>
  std::optional<SweptHit<double>>
  operator()(const SphereShape& ball_shape, const Shape& other_shape) const
  {
    const auto way_at = [&](double time)
    {
      const Sphere<double> here{ball.place_at(time), ball_shape.radius};
      return way_between(here, placed(other.pose_at(time), other_shape));
    };
    const double allowed = slack > 0 ? slack + std::max(0.0, -way_at(from).length) : 0;
    const Vector3<double> acceleration = ball.acceleration - other.acceleration;
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
  /// Only balls are swept.
  template <class Shape, class Other>
  std::optional<SweptHit<double>> operator()(const Shape&, const Other&) const
  {
    return std::nullopt;
  }
};
// [course_touch]

} // namespace cookbook
