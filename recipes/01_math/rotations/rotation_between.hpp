#pragma once

/// \file
/// \brief The shortest rotation that turns one direction into another, also into the opposite.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/power_of_two.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>
#include <type_traits>

namespace cookbook
{

// [rotation_between_opposite]
/// rotation_between() for vectors that are nearly opposite, with the cosine between them.
///
/// The cross product is the axis, and all that is left of it must be right. Exactly opposite
/// vectors, or those less than 1e-300 from it, are half a turn apart, about the axis perpendicular
/// to `from` and to the first of x, y, z that `from` has least of.
template <class Real>
Quaternion<Real>
rotation_to_opposite(const Vector3<Real>& from, const Vector3<Real>& to, const Real& cosine)
{
  using std::sqrt;
  using W = Wide<Real>;
  constexpr bool wider = !std::is_same_v<W, Real>; // then all products are exact as they are
  const Vector3<W> a = wider ? Vector3<W>(widen(from)) : enlarged(widen(from));
  const Vector3<W> b = wider ? Vector3<W>(widen(to)) : enlarged(widen(to));
  Direction<W> axis = normalize<W>(wider ? Vector3<W>(a.cross(b)) : accurate_cross(a, b));
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
  const auto unsafe = [](const Real& square)
  { return square < SafeSquares<Real>::least || square > SafeSquares<Real>::most; };
  Vector3<Real> a = from, b = to;
  Real aa = a.squaredNorm(), bb = b.squaredNorm();
  if (unsafe(aa) || unsafe(bb) || unsafe(aa * bb))
  {
    if (from.isZero(0) || to.isZero(0))
    {
      return Quaternion<Real>::Identity();
    }
    a = scaled<Real>(from).v, b = scaled<Real>(to).v;
    aa = a.squaredNorm(), bb = b.squaredNorm();
  }
  const Real length = sqrt(aa * bb), along = a.dot(b);
  if (along < Real(-0.9) * length)
  {
    return rotation_to_opposite<Real>(from, to, along / length);
  }
  // Half the turn's cosine and, as a vector, its sine: both times twice that cosine, and `length`.
  const Real w = length + along;
  const Vector3<Real> v = a.cross(b);
  const Real scale = Real(1) / sqrt(w * w + v.squaredNorm());
  return {w * scale, v.x() * scale, v.y() * scale, v.z() * scale};
}
// [rotation_between]

} // namespace cookbook
