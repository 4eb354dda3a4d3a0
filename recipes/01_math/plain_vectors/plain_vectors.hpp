#pragma once

/// \file
/// \brief Vectors by the formulas as they stand: length, direction, projection, reflection, angle,
/// lerp.
///
/// Right in a room, from a millimetre to a kilometre. The functions of the same names in `cookbook`
/// call these and hold for vectors of any size.

#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook::plain
{

// [length]
/// |v|, the length of a vector [unit of the vector].
template <class Real>
Real length(const Vector3<Real>& v)
{
  using std::sqrt;
  return sqrt(v.dot(v));
}

/// v / |v|, the direction of a vector: length one. The zero vector points up, along +y.
template <class Real>
Vector3<Real> normalize(const Vector3<Real>& v)
{
  const Real l = length(v);
  return l == Real(0) ? Vector3<Real>(Vector3<Real>::UnitY()) : Vector3<Real>(v / l);
}
// [length]

// [projection]
/// How many times `n` the projection of `a` on the line of `n` is: (a·n) / (n·n); M3. Zero if `n`
/// is.
template <class Real>
Real projection_ratio(const Vector3<Real>& a, const Vector3<Real>& n)
{
  const Real squared = n.dot(n);
  return squared == Real(0) ? Real(0) : Real(a.dot(n) / squared);
}

/// The part of `a` along `n`, which may have any length; M3. The zero vector if `n` is zero.
template <class Real>
Vector3<Real> project(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return n * projection_ratio(a, n);
}

/// The part of `a` perpendicular to `n`; M3. It is `a` if `n` is zero.
template <class Real>
Vector3<Real> reject(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return a - n * projection_ratio(a, n);
}

/// The reflection of `v` in a plane with the normal `n`; M4. It is `v` if `n` is zero.
template <class Real>
Vector3<Real> reflect(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return v - n * (Real(2) * projection_ratio(v, n));
}
// [projection]

// [angle]
/// The angle between two vectors, from 0 to π [rad]; M5. Zero if one of them is zero.
template <class Real>
Real angle(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return std::atan2(length<Real>(a.cross(b)), a.dot(b));
}
// [angle]

// [lerp]
/// Linear interpolation: from `a` at t = 0 to `b` at t = 1, on a straight line.
template <class Real>
Vector3<Real> lerp(const Vector3<Real>& a, const Vector3<Real>& b, const Real& t)
{
  return a + t * (b - a);
}

/// Inverse lerp: the t at which a number is `x` on its way from `a` to `b`. Zero if `a` is `b`.
template <class Real>
Real inverse_lerp(const Real& a, const Real& b, const Real& x)
{
  return a == b ? Real(0) : Real((x - a) / (b - a));
}
// [lerp]

// [damp]
/// Damping that does not depend on the frame rate: what is left of the way from `x` to `target`
/// falls by the factor e in each 1/rate seconds. `rate` [1/s] and `time` [s] are zero or more.
///
/// At rate 0 it is `x`. Two steps of half the time are one step of the whole.
template <class Real>
Vector3<Real> damp(const Vector3<Real>& x, const Vector3<Real>& target, Real rate, Real time)
{
  return target + (x - target) * std::exp(-rate * time);
}
// [damp]

} // namespace cookbook::plain
