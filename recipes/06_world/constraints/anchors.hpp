#pragma once

/// \file
/// \brief Anchors of a joint in two bodies, and rows along a line and about an axis.

#include "05_resolution/impulse/impulse.hpp"
#include "06_world/constraints/constraint_row.hpp"

#include <stdexcept>
#include <string>

namespace cookbook
{

// [anchors]
/// Where two bodies hold a joint.
struct Anchors
{
  Arms<double> arms; ///< [m], world, to the middle between the anchors, so that no moment is left
  Vector3<double> error;   ///< [m], world, from A's anchor to B's
  Vector3<double> turning; ///< [m/s²], world, by which it bends, since the anchors go in circles
};

/// Those of two bodies as they are, by anchors [m] in their frames.
inline Anchors anchors_of(
    const RigidBody& a, const RigidBody& b, const Vector3<double>& anchor_a,
    const Vector3<double>& anchor_b)
{
  const Vector3<double> to_a = a.orientation * anchor_a, to_b = b.orientation * anchor_b;
  const Vector3<double> error = b.motion.center + to_b - a.motion.center - to_a;
  return {
      {to_a + error / 2, to_b - error / 2},
      error,
      centripetal_acceleration(b.motion.angular_velocity, to_b) -
          centripetal_acceleration(a.motion.angular_velocity, to_a)};
}

/// A point [m], world, in the frame of a body.
inline Vector3<double> anchor_at(const RigidBody& body, const Vector3<double>& point)
{
  return body.orientation.conjugate() * (point - body.motion.center);
}

/// The row that keeps the anchors together along a direction, unit, world; R36.
inline ConstraintRow linear_row(const Anchors& anchors, const Vector3<double>& along)
{
  ConstraintRow row;
  row.a << -along, -anchors.arms.a.cross(along);
  row.b << along, anchors.arms.b.cross(along);
  row.error = anchors.error.dot(along);
  row.turning = anchors.turning.dot(along);
  return row;
}

/// The row that keeps B from turning against A about a direction, unit, world, where it is turned
/// by an angle [rad].
inline ConstraintRow angular_row(const Vector3<double>& about, double angle)
{
  ConstraintRow row;
  row.a << Vector3<double>::Zero(), -about;
  row.b << Vector3<double>::Zero(), about;
  row.error = angle;
  return row;
}
// [anchors]

/// Refuses a vector of a joint that is not finite, std::invalid_argument.
inline void check_finite(const Vector3<double>& vector, const char* member)
{
  if (!vector.allFinite())
  {
    throw std::invalid_argument(std::string("joint: ") + member + " is not finite");
  }
}

} // namespace cookbook
