#pragma once

/// \file
/// \brief What is made of two vectors: cross product, part along and across, mirror image, mixture.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/vectors/power_of_two.hpp"

#include <cmath>
#include <type_traits>

namespace cookbook
{

// [along]
/// Calls `formula(a, n, fraction)` for vectors of any size, where the part of `a` along `n` is
/// `fraction` times `n`. The formula must be linear in `a`. The zero vector `n` has the fraction 0.
template <class Real, class Formula>
Vector3<Real>
with_fraction_any_size(const Vector3<Real>& a, const Vector3<Real>& n, const Formula& formula)
{
  if constexpr (std::is_floating_point_v<Real>)
  {
    const Scaled<Real> p = scaled<Real>(a), q = scaled<Real>(n);
    const Real squared = q.v.squaredNorm();
    const Real fraction = squared == Real(0) ? Real(0) : p.v.dot(q.v) / squared;
    return times_power_of_two<Real>(formula(p.v, q.v, fraction), p.exponent);
  }
  return formula(a, n, Real(0));
}

/// The same, at once where fraction and square are ordinary; M3.
template <class Real, class Formula>
Vector3<Real> with_fraction(const Vector3<Real>& a, const Vector3<Real>& n, const Formula& formula)
{
  const Real squared = n.squaredNorm(), dot = a.dot(n);
  if (is_ordinary<Real>(squared))
  {
    const Real fraction = dot / squared;
    if (is_ordinary<Real>(fraction < Real(0) ? -fraction : fraction) ||
        is_ordinary<Real>(a.squaredNorm()))
    {
      return formula(a, n, fraction);
    }
  }
  return with_fraction_any_size<Real>(a, n, formula);
}
// [along]

// [project]
/// The part of `a` along `n`, which may have any length; M3. The zero vector if `n` is zero.
///
/// Each component is within 8 u |a| of the exact one, or within the smallest number, for all finite
/// vectors; infinite only where that reaches beyond the largest number.
template <class Real>
Vector3<Real> project(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return with_fraction<Real>(
      a, n, [](const auto&, const auto& q, const Real& fraction) { return q * fraction; });
}

/// The part of `a` across `n`, which may have any length; M3. It is `a` if `n` is zero.
///
/// Each component is within 10 u |a| of the exact one.
template <class Real>
Vector3<Real> reject(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return with_fraction<Real>(
      a, n, [](const auto& p, const auto& q, const Real& fraction) { return p - q * fraction; });
}
// [project]

// [reflect_unit]
/// The mirror image of `v` in a plane with the unit normal `n`; M4.
///
/// A normal that is not of length one also changes the length of `v`.
template <class Real>
Vector3<Real> reflect_unit(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return v - n * (Real(2) * v.dot(n));
}
// [reflect_unit]

// [reflect]
/// The mirror image of `v` in a plane with the normal `n` of any length; M4. It is `v` if `n` is
/// zero.
///
/// Each component is within 18 u |v| of the exact one.
template <class Real>
Vector3<Real> reflect(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return with_fraction<Real>(
      v, n,
      [](const auto& p, const auto& q, const Real& fraction)
      { return p - q * (fraction + fraction); });
}
// [reflect]

// [lerp]
/// From `a` at t = 0 to `b` at t = 1, on a straight line.
///
/// Exact at both ends, and no component ever turns back between them; not even huge ones overflow.
template <class Real>
Vector3<Real> lerp(const Vector3<Real>& a, const Vector3<Real>& b, Real t)
{
  return {std::lerp(a.x(), b.x(), t), std::lerp(a.y(), b.y(), t), std::lerp(a.z(), b.z(), t)};
}
// [lerp]

} // namespace cookbook
