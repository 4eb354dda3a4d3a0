#pragma once

/// \file
/// \brief Ways with rotations as one writes them first, kept to be asserted to fail.

#include "01_math/rotations/euler_angles.hpp"

#include <cmath>

namespace cookbook
{

// [quaternion_by_w]
/// The quaternion of a rotation matrix by its trace alone: divides by w, which half turns lack.
template <class Real>
Quaternion<Real> quaternion_by_w(const Matrix3<Real>& r)
{
  const Real w = std::sqrt(std::max(Real(0), 1 + r.trace())) / 2;
  return {
      w, (r(2, 1) - r(1, 2)) / (4 * w), (r(0, 2) - r(2, 0)) / (4 * w),
      (r(1, 0) - r(0, 1)) / (4 * w)};
}
// [quaternion_by_w]

/// A quaternion over the root of its square, wherever that may be.
template <class Real>
Quaternion<Real> quaternion_over_root(const Quaternion<Real>& q)
{
  return Quaternion<Real>(q.coeffs() / std::sqrt(q.dot(q)));
}

/// The matrix of a quaternion that is taken to have length one.
template <class Real>
Matrix3<Real> matrix_of_unit(const Quaternion<Real>& q)
{
  const Real w = q.w(), x = q.x(), y = q.y(), z = q.z();
  Matrix3<Real> r;
  r << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), //
      2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
      2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y);
  return r;
}

// [slerp_by_cosine]
/// The way between two quaternions by the angle of their dot product; divides by its sine, and
/// takes the longer way where the signs differ.
template <class Real>
Quaternion<Real> slerp_by_cosine(const Quaternion<Real>& a, const Quaternion<Real>& b, Real t)
{
  const Real angle = std::acos(a.dot(b));
  return Quaternion<Real>(
      (a.coeffs() * std::sin((1 - t) * angle) + b.coeffs() * std::sin(t * angle)) /
      std::sin(angle));
}
// [slerp_by_cosine]

/// The rotation between two vectors by 1 + cos and the cross product, which opposite ones lack.
template <class Real>
Quaternion<Real> between_by_half(const Vector3<Real>& from, const Vector3<Real>& to)
{
  const Vector3<Real> a = from / std::sqrt(from.dot(from)), b = to / std::sqrt(to.dot(to));
  const Vector3<Real> v = a.cross(b);
  return quaternion_over_root(Quaternion<Real>(1 + a.dot(b), v.x(), v.y(), v.z()));
}

// [angles_by_sine]
/// Three angles, each by itself: near the lock two of them are made of rounding.
template <class Real>
EulerAngles<Real> angles_by_sine(const Matrix3<Real>& r)
{
  return {std::atan2(r(0, 2), r(2, 2)), std::asin(-r(1, 2)), std::atan2(r(1, 0), r(1, 1))};
}
// [angles_by_sine]

} // namespace cookbook
