#pragma once

/// \file
/// \brief The shortest rotation that turns one direction into another, also into the opposite.

#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>

namespace cookbook
{

// [accurate_cross]
/// ab - cd, right to two units in the last place also where the products nearly cancel.
template <class Real>
Real difference_of_products(const Real& a, const Real& b, const Real& c, const Real& d)
{
  using std::fma;
  const Real rounded = c * d;
  return fma(a, b, -rounded) + fma(-c, d, rounded);
}

/// The cross product with each component right, also of vectors that are nearly parallel.
template <class Real>
Vector3<Real> accurate_cross(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return {
      difference_of_products<Real>(a.y(), b.z(), a.z(), b.y()),
      difference_of_products<Real>(a.z(), b.x(), a.x(), b.z()),
      difference_of_products<Real>(a.x(), b.y(), a.y(), b.x())};
}
// [accurate_cross]

// [rotation_between_opposite]
/// A vector times a power of two, exactly: its largest component lies between 2⁴⁰⁰ and 2⁴⁰¹, so
/// that products keep the digits of the smallest components.
template <class Real>
Vector3<Real> enlarged(const Vector3<Real>& v)
{
  using std::ilogb, std::ldexp;
  const int exponent = 400 - ilogb(v.cwiseAbs().maxCoeff());
  return {ldexp(v.x(), exponent), ldexp(v.y(), exponent), ldexp(v.z(), exponent)};
}

/// rotation_between() for vectors that are nearly opposite, with the cosine between them.
///
/// The cross product is the axis, and all that is left of it must be right. Exactly opposite
/// vectors, or those less than 1e-300 from it, are half a turn apart, about the axis square to
/// `from` and to the first of x, y, z that `from` has least of.
template <class Real>
Quaternion<Real>
rotation_to_opposite(const Vector3<Real>& from, const Vector3<Real>& to, const Real& cosine)
{
  using std::sqrt;
  using W = Wide<Real>;
  const Vector3<W> a = enlarged<W>(widen(from)), b = enlarged<W>(widen(to));
  Direction<W> axis = normalize<W>(accurate_cross(a, b));
  if (axis.length == W(0))
  {
    int least = 0;
    a.cwiseAbs().minCoeff(&least);
    axis.unit = normalize<W>(a.cross(Vector3<W>::Unit(least))).unit;
  }
  const W sine = axis.length / (normalize<W>(a).length * normalize<W>(b).length);
  const W half_sine = sqrt((W(1) - W(cosine)) / W(2)), half_cosine = sine / (W(2) * half_sine);
  const Vector3<W> v = axis.unit * half_sine;
  return Quaternion<W>(half_cosine, v.x(), v.y(), v.z()).template cast<Real>();
}
// [rotation_between_opposite]

// [rotation_between]
/// The shortest rotation that turns the direction of `from` into that of `to`, a unit quaternion.
///
/// Any finite vectors: parallel ones need no turn, opposite ones half a turn about the axis that
/// rotation_to_opposite() names, and the zero vector, which has no direction, gives no turn.
template <class Real>
Quaternion<Real> rotation_between(const Vector3<Real>& from, const Vector3<Real>& to)
{
  using std::sqrt;
  const Direction<Real> a = normalize(from), b = normalize(to);
  const Real cosine = a.unit.dot(b.unit);
  if (a.length == Real(0) || b.length == Real(0))
  {
    return Quaternion<Real>::Identity();
  }
  if (cosine < Real(-0.9))
  {
    return rotation_to_opposite<Real>(from, to, cosine);
  }
  // Twice the half turn's cosine, and its sine as a vector, both times that cosine.
  const Real w = Real(1) + cosine;
  const Vector3<Real> v = a.unit.cross(b.unit);
  const Real scale = Real(1) / sqrt(w * w + v.squaredNorm());
  return {w * scale, v.x() * scale, v.y() * scale, v.z() * scale};
}
// [rotation_between]

} // namespace cookbook
