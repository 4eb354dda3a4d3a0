#pragma once

/// \file
/// \brief Projection, rejection, reflection and lerp for vectors of any size.

#include "01_math/numbers/difference_of_products.hpp"
#include "01_math/plain_vectors/plain_vectors.hpp"
#include "01_math/vectors/power_of_two.hpp"

#include <cmath>
#include <type_traits>

namespace cookbook
{

// [any_size]
/// `formula(a, n)` for vectors of any size, with powers of two taken out where a square or a ratio
/// would leave the range. The formula is linear in `a`, and the length of `n` does not matter to
/// it.
template <class Real, class Formula>
Vector3<Real> at_any_size(const Vector3<Real>& a, const Vector3<Real>& n, const Formula& formula)
{
  if constexpr (std::is_floating_point_v<Real>)
  {
    const Real ratio = plain::projection_ratio(a, n);
    if (!is_ordinary<Real>(n.squaredNorm()) ||
        !(is_ordinary<Real>(std::abs(ratio)) || is_ordinary<Real>(a.squaredNorm())))
    {
      const Scaled<Real> p = scaled<Real>(a), q = scaled<Real>(n);
      return times_power_of_two<Real>(formula(p.v, q.v), p.exponent);
    }
  }
  return formula(a, n);
}
// [any_size]

// [project]
/// The part of `a` along `n`, which may have any length; M3. The zero vector if `n` is zero.
///
/// Each component is within 8 u |a| of the exact one, or within the smallest number, for all finite
/// vectors; infinite only where that reaches beyond the largest number.
template <class Real>
Vector3<Real> project(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return at_any_size<Real>(a, n, plain::project<Real>);
}
// [project]

/// The part of `a` across `n`, which may have any length; M3. It is `a` if `n` is zero.
///
/// Each component is within 10 u |a| of the exact one.
template <class Real>
Vector3<Real> reject(const Vector3<Real>& a, const Vector3<Real>& n)
{
  return at_any_size<Real>(a, n, plain::reject<Real>);
}

// [reflect_unit]
/// The reflection of `v` in a plane with the unit normal `n`; M4.
///
/// A normal that is not of length one also changes the length of `v`.
template <class Real>
Vector3<Real> reflect_unit(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return v - n * (Real(2) * v.dot(n));
}
// [reflect_unit]

/// The reflection of `v` in a plane with the normal `n` of any length; M4. It is `v` if `n` is
/// zero.
///
/// Each component is within 18 u |v| of the exact one.
template <class Real>
Vector3<Real> reflect(const Vector3<Real>& v, const Vector3<Real>& n)
{
  return at_any_size<Real>(v, n, plain::reflect<Real>);
}

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
