#pragma once

/// \file
/// \brief The difference of two products, and a cross product made of it, without cancellation.

#include "common/math/wide.hpp"

#include <cmath>
#include <type_traits>

namespace cookbook
{

// [difference_naive]
/// ad − bc as it is written: where the products are nearly equal, their roundings are all that is
/// left.
template <class Real>
Real difference_naive(Real a, Real d, Real b, Real c)
{
  return a * d - b * c;
}
// [difference_naive]

// [difference_fused]
/// ad − bc with what both products lost put back. The products swapped give the same with the other
/// sign, to the last bit.
///
/// Within 2 u of itself, and the smallest number; infinite or NaN where a product overflows.
template <class Real>
Real difference_fused(Real a, Real d, Real b, Real c)
{
  const Real first = a * d, second = b * c;
  const Real lost_first = std::fma(a, d, -first), lost_second = std::fma(b, c, -second);
  return (first - second) + (lost_first - lost_second);
}
// [difference_fused]

// [difference_scaled]
/// ad − bc of finite numbers that are not zero, with powers of two taken out of the products.
template <class Real>
Real difference_scaled(Real a, Real d, Real b, Real c)
{
  const int of_a = std::ilogb(a), of_b = std::ilogb(b);
  const int ad = of_a + std::ilogb(d), bc = of_b + std::ilogb(c), most = ad > bc ? ad : bc;
  const Real scaled = difference_fused(
      std::ldexp(a, -of_a), std::ldexp(d, of_a - most), std::ldexp(b, -of_b),
      std::ldexp(c, of_b - most));
  return std::ldexp(scaled, most);
}
// [difference_scaled]

// [difference_of_products]
/// ad − bc, right for all finite numbers: within 2u of the answer, and one smallest number where
/// products underflow; infinite only where the true answer does not fit.
///
/// The products of floats are exact in double. A double has nothing wider: there, what both
/// products lose is put back. Infinite and NaN input gives what ad − bc gives.
template <class Real>
Real difference_of_products(Real a, Real d, Real b, Real c)
{
  if constexpr (!std::is_same_v<Wide<Real>, Real>)
  {
    return static_cast<Real>(Wide<Real>(a) * Wide<Real>(d) - Wide<Real>(b) * Wide<Real>(c));
  }
  else
  {
    const Real answer = difference_fused(a, d, b, c);
    if (std::isfinite(answer))
    {
      return answer;
    }
    const auto is_plain = [](Real x) { return x == Real(0) || !std::isfinite(x); };
    const bool plain = is_plain(a) || is_plain(d) || is_plain(b) || is_plain(c);
    return plain ? difference_naive(a, d, b, c) : difference_scaled(a, d, b, c);
  }
}
// [difference_of_products]

// [accurate_cross]
/// a × b, each component within 2u of the true one and one smallest number, also of vectors that
/// are nearly parallel.
template <class Real>
Vector3<Real> accurate_cross(const Vector3<Real>& a, const Vector3<Real>& b)
{
  return {
      difference_of_products(a.y(), b.z(), a.z(), b.y()),
      difference_of_products(a.z(), b.x(), a.x(), b.z()),
      difference_of_products(a.x(), b.y(), a.y(), b.x())};
}
// [accurate_cross]

} // namespace cookbook
