#pragma once

/// \file
/// \brief Quaternions of any size: their product, the one of length one, and the rotation matrix.

#include "common/math/norm.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [product]
/// The product ab: turns as b does, then as a does.
template <class Real>
Quaternion<Real> product(const Quaternion<Real>& a, const Quaternion<Real>& b)
{
  return {
      a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
      a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
      a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
      a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x()};
}
// [product]

/// sa + tb, part by part.
template <class Real>
Quaternion<Real>
combined(const Real& s, const Quaternion<Real>& a, const Real& t, const Quaternion<Real>& b)
{
  return {
      s * a.w() + t * b.w(), s * a.x() + t * b.x(), s * a.y() + t * b.y(), s * a.z() + t * b.z()};
}

/// sq, part by part.
template <class Real>
Quaternion<Real> times(const Real& s, const Quaternion<Real>& q)
{
  return {s * q.w(), s * q.x(), s * q.y(), s * q.z()};
}

/// The dot product of two quaternions; of one with itself, its squared length.
template <class Real>
Real dot(const Quaternion<Real>& a, const Quaternion<Real>& b)
{
  return (a.w() * b.w() + a.x() * b.x()) + (a.y() * b.y() + a.z() * b.z());
}

/// A quaternion whose squared length neither underflows nor overflows, and that squared length.
template <class Real>
struct SizedQuaternion
{
  Quaternion<Real> q; ///< in the direction of the one that was asked for
  Real squared;       ///< |q|², never zero
};

// [sized]
/// Takes a power of two out of a quaternion where its squares would not fit; zero becomes 1.
template <class Real>
SizedQuaternion<Real> sized(const Quaternion<Real>& q)
{
  using std::ilogb, std::ldexp;
  const Real squared = dot(q, q);
  // Not a number is neither less nor more: it comes out as it went in.
  if (!(squared < SafeSquares<Real>::least) && !(squared > SafeSquares<Real>::most))
  {
    return {q, squared};
  }
  const Real largest = q.coeffs().cwiseAbs().maxCoeff();
  if (largest == Real(0))
  {
    return {Quaternion<Real>::Identity(), Real(1)};
  }
  const int exponent = ilogb(largest);
  const Quaternion<Real> scaled(
      ldexp(q.w(), -exponent), ldexp(q.x(), -exponent), ldexp(q.y(), -exponent),
      ldexp(q.z(), -exponent));
  return {scaled, dot(scaled, scaled)};
}
// [sized]

// [unit_quaternion]
/// The quaternion of length one in the direction of any finite one; zero becomes 1, no turn.
///
/// One that rounding has moved off length one is brought back by a step of Newton's method, without
/// a root.
template <class Real>
Quaternion<Real> unit_quaternion(const Quaternion<Real>& q)
{
  using std::sqrt;
  const Real excess = dot(q, q) - Real(1);
  // The step leaves 3/8 excess².
  if (excess * excess <= std::numeric_limits<Real>::epsilon() / Real(2))
  {
    return times<Real>(Real(1) - excess / Real(2), q);
  }
  const SizedQuaternion<Real> safe = sized(q);
  return times<Real>(Real(1) / sqrt(safe.squared), safe.q);
}
// [unit_quaternion]

// [rotation_matrix]
/// The rotation matrix of any finite quaternion, taken as its direction; M16.
///
/// Each entry is right to four units in the last place of one. Zero is no turn.
template <class Real>
Matrix3<Real> rotation_matrix(const Quaternion<Real>& any)
{
  const SizedQuaternion<Real> safe = sized(any);
  const Real s = Real(2) / safe.squared;
  const Real w = safe.q.w(), x = safe.q.x(), y = safe.q.y(), z = safe.q.z();
  const Real sx = s * x, sy = s * y, sz = s * z;
  Matrix3<Real> r;
  r << Real(1) - (sy * y + sz * z), sx * y - sz * w, sx * z + sy * w, //
      sx * y + sz * w, Real(1) - (sx * x + sz * z), sy * z - sx * w,  //
      sx * z - sy * w, sy * z + sx * w, Real(1) - (sx * x + sy * y);
  return r;
}
// [rotation_matrix]

} // namespace cookbook
