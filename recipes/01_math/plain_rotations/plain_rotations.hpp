#pragma once

/// \file
/// \brief Rotations by the formulas as they stand: axis and angle, quaternions, slerp, orthonormal
/// bases.
///
/// Quaternions have length one, axes too.

#include "01_math/plain_vectors/plain_vectors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook::plain
{

// [rotated]
/// A vector turned about the unit axis `k` by an angle [rad]: Rodrigues' formula, M8.
template <class Real>
Vector3<Real> rotated(const Vector3<Real>& v, const Vector3<Real>& k, const Real& angle)
{
  using std::cos, std::sin;
  return cos(angle) * v + sin(angle) * k.cross(v) + (Real(1) - cos(angle)) * k.dot(v) * k;
}

/// The quaternion of a turn about the unit axis `k` by an angle [rad].
template <class Real>
Quaternion<Real> quaternion_about(const Vector3<Real>& k, const Real& angle)
{
  using std::cos, std::sin;
  const Vector3<Real> u = k * sin(angle / Real(2));
  return {cos(angle / Real(2)), u.x(), u.y(), u.z()};
}
// [rotated]

// [axis_and_angle]
/// A turn: about a unit axis, by an angle [rad].
template <class Real>
struct AxisAngle
{
  Vector3<Real> axis; ///< [1] length one
  Real angle;         ///< [rad] from 0 to π
};

/// Axis and angle of a quaternion. One that does not turn gets the axis +y and the angle 0.
template <class Real>
AxisAngle<Real> axis_and_angle(const Quaternion<Real>& q)
{
  const Vector3<Real> u = q.w() < Real(0) ? Vector3<Real>(-q.vec()) : Vector3<Real>(q.vec());
  return {normalize(u), Real(2) * std::atan2(length(u), std::abs(q.w()))};
}
// [axis_and_angle]

// [slerp]
/// Slerp: the orientation at the fraction t of the shorter way from a to b, at a constant rate. It
/// is `a` where a and b are the same to rounding.
template <class Real>
Quaternion<Real> slerp(const Quaternion<Real>& a, const Quaternion<Real>& b, const Real& t)
{
  const Real cosine = a.dot(b), sign = cosine < Real(0) ? Real(-1) : Real(1);
  const Real angle = std::acos(std::min(Real(1), sign * cosine)), sine = std::sin(angle);
  const Real of_a = sine == Real(0) ? Real(1) : std::sin((Real(1) - t) * angle) / sine;
  const Real of_b = sine == Real(0) ? Real(0) : std::sin(t * angle) / sine;
  return Quaternion<Real>(of_a * a.coeffs() + sign * of_b * b.coeffs());
}
// [slerp]

// [basis]
/// An orthonormal basis, right-handed, whose third column is the direction of `n`: the other two
/// are tangents. The zero vector counts as +y.
template <class Real>
Matrix3<Real> basis_from_normal(const Vector3<Real>& n)
{
  const Vector3<Real> z = normalize(n);
  int least = 0;
  z.cwiseAbs().minCoeff(&least); // the coordinate axis that is farthest from the normal
  const Vector3<Real> x = normalize<Real>(Vector3<Real>::Unit(least).cross(z));
  Matrix3<Real> basis;
  basis << x, z.cross(x), z;
  return basis;
}

/// The rotation next to a matrix that has drifted from one, by Gram–Schmidt: the first column keeps
/// its direction, the second its side of it, the third is their cross product.
///
/// It is a rotation to rounding for every matrix of a room: where the first two columns are
/// parallel to a thousandth, the second one is a tangent of basis_from_normal().
template <class Real>
Matrix3<Real> orthonormalize(const Matrix3<Real>& m)
{
  const Vector3<Real> x = normalize<Real>(m.col(0));
  Vector3<Real> y = reject<Real>(m.col(1), x);
  if (length(y) <= Real(1e-3) * length<Real>(m.col(1)))
  {
    y = basis_from_normal(x).col(0);
  }
  y = normalize<Real>(reject<Real>(y, x)); // once more, for what rounding has left along x
  Matrix3<Real> r;
  r << x, y, x.cross(y);
  return r;
}
// [basis]

// [turned_by]
/// An orientation after a time step [s] of a steady angular velocity [rad/s], seen from the world;
/// M9.
template <class Real>
Quaternion<Real>
turned_by(const Quaternion<Real>& q, const Vector3<Real>& angular_velocity, const Real& step)
{
  const Real angle = length(angular_velocity) * step;
  return (quaternion_about(normalize(angular_velocity), angle) * q).normalized();
}
// [turned_by]

} // namespace cookbook::plain
