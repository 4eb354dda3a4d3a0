#pragma once

/// \file
/// \brief Three ways to turn an orientation that go wrong, kept to be asserted to fail.

#include "05_resolution/spinning_bodies/rotation_by.hpp"

namespace cookbook
{

// [euler_angles]
/// The rotation of three angles [rad] about y, x and z, the one about z first.
template <class Real>
Quaternion<Real> from_angles(const Vector3<Real>& angles)
{
  const Vector3<Real> x(angles.x(), 0, 0), y(0, angles.y(), 0), z(0, 0, angles.z());
  return rotation_by(y) * rotation_by(x) * rotation_by(z);
}

/// Angles [rad] about the axes, to which the angular velocity [rad/s] is added as if rotations
/// could be added: right about one axis only.
template <class Real>
Vector3<Real>
angles_added(const Vector3<Real>& angles, const Vector3<Real>& angular_velocity, Real step)
{
  return angles + step * angular_velocity;
}
// [euler_angles]

// [quaternion_added]
/// A quaternion to which the start of its way is added, a straight line off the sphere: each step
/// makes it longer by √(1 + (ωh/2)²), and turns it by 2 atan(ωh/2) only; M10.
template <class Real>
Quaternion<Real> quaternion_added(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, Real step)
{
  const Vector3<Real> half = (step / 2) * angular_velocity;
  const Quaternion<Real> way = Quaternion<Real>(0, half.x(), half.y(), half.z()) * orientation;
  return Quaternion<Real>(
      orientation.w() + way.w(), orientation.x() + way.x(), orientation.y() + way.y(),
      orientation.z() + way.z());
}

/// The same, brought back to length one: the turn is still too small.
template <class Real>
Quaternion<Real> quaternion_added_and_normalised(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, Real step)
{
  return quaternion_added(orientation, angular_velocity, step).normalized();
}
// [quaternion_added]

} // namespace cookbook
