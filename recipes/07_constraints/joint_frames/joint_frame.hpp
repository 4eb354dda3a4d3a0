#pragma once

/// \file
/// \brief Where a joint sits in its two bodies: a point and three axes in each.

#include "06_world/constraints/anchors.hpp"
#include "common/math/norm.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [joint_frame]
/// Where a joint sits in a body: an anchor, and three axes, of which x is the joint's axis.
struct JointFrame
{
  Vector3<double> anchor{0, 0, 0};     ///< [m], in the body's frame
  Quaternion<double> axes{1, 0, 0, 0}; ///< unit, from the joint's axes to the body's
};

/// How the two frames of a joint lie; R54.
struct FramePose
{
  Matrix3<double> a, b;      ///< columns are the joint's axes in each body, world
  Quaternion<double> turned; ///< from B's to A's: how B is turned against A, in A's joint axes
  Arms<double> arms;         ///< [m], world, from both centres to B's anchor
  Vector3<double> apart;     ///< [m], world, from A's anchor to B's
  Vector3<double> speed;     ///< [m/s], world, at which that changes
  Vector3<double> bend;      ///< [m/s²], world, by which it bends as the bodies turn
};

/// That of two bodies as they are.
inline FramePose frame_pose(
    const RigidBody& a, const RigidBody& b, const JointFrame& frame_a, const JointFrame& frame_b)
{
  const Quaternion<double> axes_a = a.orientation * frame_a.axes;
  const Quaternion<double> axes_b = b.orientation * frame_b.axes;
  const Vector3<double> to_a = a.orientation * frame_a.anchor,
                        to_b = b.orientation * frame_b.anchor;
  const Vector3<double> apart = b.motion.center + to_b - a.motion.center - to_a;
  const Vector3<double>&w_a = a.motion.angular_velocity, &w_b = b.motion.angular_velocity;
  return {
      axes_a.toRotationMatrix(),
      axes_b.toRotationMatrix(),
      axes_a.conjugate() * axes_b,
      {to_a + apart, to_b},
      apart,
      b.motion.velocity + w_b.cross(to_b) - a.motion.velocity - w_a.cross(to_a),
      centripetal_acceleration(w_b, to_b) - centripetal_acceleration(w_a, to_a)};
}
// [joint_frame]

// [frame_at]
/// The axes of which x lies along an axis, by the shortest turn; where that is −x, half a turn
/// about y. std::invalid_argument if the axis is zero or not finite.
inline Quaternion<double> axes_about(const Vector3<double>& axis)
{
  check_finite(axis, "axis");
  if (axis.isZero(0))
  {
    throw std::invalid_argument("joint: axis is zero");
  }
  const Vector3<double> unit = normalize<double>(axis).unit;
  const double across = unit.y() * unit.y() + unit.z() * unit.z();
  const double sum = unit.x() < 0 ? across / (1 - unit.x()) : 1 + unit.x(); // 1 + x to all digits
  const Quaternion<double> turn(sum, 0, -unit.z(), unit.y());
  return across == 0 && unit.x() < 0 ? Quaternion<double>(0, 0, 1, 0) : turn.normalized();
}

/// The axes of which x lies along an axis and y as close to a second direction as it can.
/// std::invalid_argument if either is zero or not finite, or both lie along one line.
inline Quaternion<double> axes_about(const Vector3<double>& axis, const Vector3<double>& second)
{
  const Quaternion<double> about = axes_about(axis);
  check_finite(second, "second axis");
  const Vector3<double> unit = normalize<double>(second).unit, in_axes = about.conjugate() * unit;
  if (second.isZero(0) || std::hypot(in_axes.y(), in_axes.z()) < 1e-6)
  {
    throw std::invalid_argument("joint: second axis lies along the first, or is zero");
  }
  const Vector3<double> y = normalize<double>({0, in_axes.y(), in_axes.z()}).unit;
  Matrix3<double> turn;
  turn << 1, 0, 0, 0, y.y(), -y.z(), 0, y.z(), y.y();
  return (about * Quaternion<double>(turn)).normalized();
}

/// A frame at a point [m], world, with axes from the joint's to the world's, in a body as it is.
inline JointFrame
frame_at(const RigidBody& body, const Vector3<double>& point, const Quaternion<double>& axes)
{
  return {anchor_at(body, point), (body.orientation.conjugate() * axes).normalized()};
}

/// Refuses a frame that is none, std::invalid_argument.
inline void check_frame(const JointFrame& frame, const std::string& member)
{
  check_finite(frame.anchor, (member + ".anchor").c_str());
  const double length = frame.axes.norm();
  if (!(std::abs(length - 1) <= 1e-6))
  {
    throw std::invalid_argument(
        "joint: " + member + ".axes have the length " + std::to_string(length) + ", not 1");
  }
}
// [frame_at]

} // namespace cookbook
