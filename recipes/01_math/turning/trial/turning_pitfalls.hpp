#pragma once

/// \file
/// \brief Ways to turn an orientation that go wrong, kept to be asserted to fail.

#include "01_math/turning/rotation_by.hpp"

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

// [half_angle_rational]
/// Cosine and sine of half the angle by a fraction, with a fourth of the angle for its tangent: no
/// root, length one to rounding, and a turn of 4 atan(ωh/4).
template <class Real>
Quaternion<Real> turned_by_fraction(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, Real step)
{
  const Vector3<Real> tangent = (step / 4) * angular_velocity;
  const Real square = tangent.squaredNorm(), scale = 1 / (1 + square);
  Quaternion<Real> turn((1 - square) * scale, 0, 0, 0);
  turn.vec() = tangent * (2 * scale);
  return turn * orientation;
}
// [half_angle_rational]

// [matrix_added]
/// A matrix to which the start of its way is added, then made orthonormal column by column as Gram
/// and Schmidt do: the turn is too small, and not about ω alone, for the first column keeps its
/// direction and the others give way.
template <class Real>
Matrix3<Real>
matrix_added(const Matrix3<Real>& axes, const Vector3<Real>& angular_velocity, Real step)
{
  Matrix3<Real> r = axes;
  for (int i = 0; i < 3; ++i)
  {
    r.col(i) += step * angular_velocity.cross(axes.col(i));
  }
  r.col(0).normalize();
  r.col(1) = (r.col(1) - r.col(0) * r.col(0).dot(r.col(1))).normalized();
  r.col(2) = r.col(0).cross(r.col(1));
  return r;
}
// [matrix_added]

/// The exponential as it is written, divided by |ω|: not a number where there is no spin.
template <class Real>
Quaternion<Real> turned_by_division(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, Real step)
{
  const Real speed = std::sqrt(angular_velocity.dot(angular_velocity));
  const Vector3<Real> v = angular_velocity / speed * std::sin(speed * step / 2);
  return Quaternion<Real>(std::cos(speed * step / 2), v.x(), v.y(), v.z()) * orientation;
}

} // namespace cookbook
