#pragma once

/// \file
/// \brief How a rigid body moves, and the velocity of one body's surface as seen from another's.

#include "common/math/vector.hpp"

namespace cookbook
{

// [relative_velocity]
/// How a rigid body moves.
template <class Real>
struct Motion
{
  Vector3<Real> center;           ///< [m], world, centre of mass
  Vector3<Real> velocity;         ///< [m/s], world, of the centre of mass
  Vector3<Real> angular_velocity; ///< [rad/s], world
};

/// Velocity [m/s] of the body's material at an arm [m], world, from its centre of mass.
template <class Real>
Vector3<Real> velocity_at_arm(const Motion<Real>& body, const Vector3<Real>& arm)
{
  return body.velocity + body.angular_velocity.cross(arm);
}

/// Velocity [m/s] of the body's material at a point [m], world.
template <class Real>
Vector3<Real> velocity_at(const Motion<Real>& body, const Vector3<Real>& point)
{
  return velocity_at_arm<Real>(body, point - body.center);
}

/// Velocity [m/s] of B's material at a point as seen from A's; S11.
template <class Real>
Vector3<Real>
relative_velocity(const Motion<Real>& a, const Motion<Real>& b, const Vector3<Real>& point)
{
  return velocity_at(b, point) - velocity_at(a, point);
}
// [relative_velocity]

// [fastest_point]
/// The speed [m/s] that no point of a body exceeds; `radius` [m] is that of its farthest point.
template <class Real>
Real fastest_point(
    const Vector3<Real>& velocity, const Vector3<Real>& angular_velocity, const Real& radius)
{
  return velocity.norm() + angular_velocity.norm() * radius;
}
// [fastest_point]

} // namespace cookbook
