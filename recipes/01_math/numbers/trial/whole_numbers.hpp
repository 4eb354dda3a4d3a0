#pragma once

/// \file
/// \brief Exact arithmetic that is quick: floats as whole multiples of one power of two.

#include <gmpxx.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace cookbook
{

/// A whole number of any size.
using Whole = mpz_class;

// [whole]
/// The digits behind the point that all numbers of a type fit in.
template <class Real>
constexpr int all_digits()
{
  return std::numeric_limits<Real>::digits - std::numeric_limits<Real>::min_exponent;
}

/// x · 2^digits, which must be a whole number.
template <class Real>
Whole whole(Real x, int digits = all_digits<Real>())
{
  constexpr int size = std::numeric_limits<Real>::digits;
  int exponent = 0;
  const Real fraction = std::frexp(x, &exponent);
  const Whole mantissa = static_cast<long>(std::ldexp(fraction, size));
  const int shift = exponent - size + digits;
  const unsigned by = static_cast<unsigned>(std::abs(shift));
  return shift >= 0 ? Whole(mantissa << by) : Whole(mantissa >> by);
}
// [whole]

/// 2^exponent.
inline Whole power_of_two(int exponent)
{
  return Whole(1) << static_cast<unsigned>(exponent);
}

} // namespace cookbook
