#pragma once

/// \file
/// \brief Rows between two frames: along an axis of A, against any turn, about an axis, and of
/// twist.

#include "06_world/constraints/joint_rows.hpp"
#include "07_constraints/joint_frames/joint_frame.hpp"
#include "common/math/trigonometry.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [axis_row]
/// The row of how far B's anchor is from A's along an axis of A's frame, 0 to 2; R54. Both pushes
/// are at B's anchor, so that no moment is left.
inline ConstraintRow axis_row(const FramePose& pose, const RigidBody& a, int axis)
{
  const Vector3<double> along = pose.a.col(axis), &w_a = a.motion.angular_velocity;
  ConstraintRow row;
  row.a << -along, -pose.arms.a.cross(along);
  row.b << along, pose.arms.b.cross(along);
  row.error = along.dot(pose.apart);
  row.turning = along.dot(pose.bend) + 2 * w_a.cross(along).dot(pose.speed) +
                centripetal_acceleration(w_a, along).dot(pose.apart);
  return row;
}

/// The three rows that keep both anchors together. What speed these have against each other before
/// a solve, such as that of gravity, is none after it, and turns with nothing.
inline void add_point_rows(FramePose pose, const RigidBody& a, JointRows& rows)
{
  pose.speed.setZero();
  for (int axis = 0; axis < 3; ++axis)
  {
    rows.add(axis_row(pose, a, axis));
  }
}
// [axis_row]

/// The pose of a joint whose anchors may only part along an axis of A's frame, 0 to 2: for the same
/// reason with no other speed.
inline FramePose parting_along(FramePose pose, int axis)
{
  const Vector3<double> along = pose.a.col(axis);
  pose.speed = along.dot(pose.speed) * along;
  return pose;
}

// [turn_rows]
/// The three rows that keep B from any turn against A: those of the rotation vector; R55. Half a
/// turn counts as its quaternion says it.
inline void add_turn_rows(const FramePose& pose, JointRows& rows)
{
  const double sign = pose.turned.w() < 0 ? -1 : 1, cosine = sign * pose.turned.w();
  const Vector3<double> vec = sign * pose.turned.vec();
  const double sine = vec.norm(), half = arc_tangent(sine, cosine), angle = 2 * half;
  const Vector3<double> turn = sine > 0 ? Vector3<double>(angle / sine * vec) : 2 * vec;
  const double curve = angle > 1e-8 ? (1 - half * cosine / sine) / (angle * angle) : 1.0 / 12;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3<double> unit = Vector3<double>::Unit(axis);
    const Vector3<double> about =
        unit + 0.5 * turn.cross(unit) + curve * turn.cross(turn.cross(unit));
    rows.add(angular_row(pose.a * about, turn[axis]));
  }
}
// [turn_rows]

// [swing_rows]
/// The two rows that keep B's x axis on A's: angle between them, times the direction about which B
/// swings, along A's y and z; R56. Half a turn counts as one about A's y.
inline void add_swing_rows(const FramePose& pose, JointRows& rows)
{
  const Vector3<double> x = pose.a.transpose() * pose.b.col(0); // B's axis in A's frame
  const double sine = std::hypot(x.y(), x.z()), angle = arc_tangent(sine, x.x());
  const bool flat = sine < 1e-8; // the ratios' limits, or half a turn
  const double ratio = flat ? 1 : angle / sine;
  const double slope = flat ? -1.0 / 3 : (angle * x.x() - sine) / (sine * sine * sine);
  const Vector3<double> swing = pose.a * x.cross(Vector3<double>::UnitX());
  for (const int axis : {1, 2})
  {
    const int other = 3 - axis;
    const double sign = axis == 1 ? -1 : 1; // of x's component across
    const Vector3<double> about = sign * (slope * x[other] * swing +
                                          ratio * (pose.a * x.cross(Vector3<double>::Unit(other))));
    const double error = flat && x.x() < 0 ? (axis == 1 ? angle : 0) : sign * ratio * x[other];
    rows.add(angular_row(flat ? Vector3<double>(pose.a.col(axis)) : about, error));
  }
}
// [swing_rows]

// [twist_row]
/// By how much [rad], −π to π, B is turned against A about A's x axis, right-handed; R56. 0 where
/// B's x axis is turned by half a turn against A's.
inline double twist_of(const FramePose& pose)
{
  const double sign = pose.turned.w() < 0 ? -1 : 1;
  return 2 * arc_tangent(sign * pose.turned.x() + 0.0, sign * pose.turned.w() + 0.0); // no -0
}

/// The row of such an angle [rad].
inline ConstraintRow twist_row(const FramePose& pose, double angle)
{
  const Vector3<double> x_a = pose.a.col(0), x_b = pose.b.col(0);
  const double sum = 1 + x_a.dot(x_b);
  return angular_row(sum > 1e-9 ? Vector3<double>((x_a + x_b) / sum) : x_a, angle);
}

/// The same angle with whole turns, the nearest to one that it had before.
inline double with_turns(double angle, double before)
{
  const double turn = 2 * std::numbers::pi;
  return angle + turn * std::round((before - angle) / turn);
}
// [twist_row]

} // namespace cookbook
