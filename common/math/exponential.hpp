#pragma once

/// \file
/// \brief The exponential function with the same bits from every compiler and C library.

#include "common/math/trigonometry.hpp"

#include <cmath>

namespace cookbook
{

// [exponential]
/// e to the power of x, within an ulp of itself, of sums and products alone.
///
/// Of the k ln 2 in x a power of two is made; for the rest, half of ln 2 at most, Taylor's series
/// leaves out less than 0.35¹⁴/14! < 2^-57. Too large a result is infinite, too small a one is
/// zero.
inline double exponential(double x)
{
  if (!(std::abs(x) < 750))
  {
    return x > 0 ? x * HUGE_VAL : x < 0 ? 0 : x;
  }
  // ln 2 in two parts; the first has so few digits that k times it is exact.
  const double k = std::floor(x * 1.4426950408889634 + 0.5);
  const double near_x = x - k * 0.6931471803691238, tail = k * 1.9082149292705877e-10;
  const double rest = near_x - tail, low = near_x - rest - tail;
  double series = 1 / 6227020800.0; // 1/13!
  for (const double term :
       {1 / 479001600.0, 1 / 39916800.0, 1 / 3628800.0, 1 / 362880.0, 1 / 40320.0, 1 / 5040.0,
        1 / 720.0, 1 / 120.0, 1 / 24.0, 1 / 6.0, 1 / 2.0})
  {
    series = term + rest * series;
  }
  return std::ldexp(1 + (rest + (low + rest * rest * series)), static_cast<int>(k));
}
// [exponential]

/// The same of another scalar type: of float by way of double, of others by their own function.
template <class Real>
Real exponential(const Real& x)
{
  if constexpr (is_float_or_double<Real>)
  {
    return static_cast<Real>(exponential(static_cast<double>(x)));
  }
  else
  {
    using std::exp;
    return exp(x);
  }
}

} // namespace cookbook
