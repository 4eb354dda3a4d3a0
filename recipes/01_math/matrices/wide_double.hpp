#pragma once

/// \file
/// \brief A double with twice the digits, and an exponent that does not end.

#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook
{

// [wide_double]
/// The number (high + low) · 2^exponent: about 105 binary digits, of any size.
///
/// `high` lies between a half and one, or is zero; `low` is what `high` has no digits for.
struct WideDouble
{
  double high = 0;  ///< the first 53 digits
  double low = 0;   ///< the next ones, at most half an ulp of `high`
  int exponent = 0; ///< the power of two that both are multiplied by

  WideDouble() = default;

  /// The sum of a number and a much smaller one, times a power of two.
  WideDouble(double number, double small = 0, int power = 0)
  {
    const double sum = number + small;
    int shift = 0;
    high = std::frexp(sum, &shift);
    low = std::ldexp(small - (sum - number), -shift);
    exponent = power + shift;
  }

  /// The nearest double: zero or infinite where it is out of range.
  explicit operator double() const { return std::ldexp(high + low, exponent); }
};

/// The number with the other sign.
inline WideDouble operator-(const WideDouble& a)
{
  WideDouble negated = a;
  negated.high = -a.high;
  negated.low = -a.low;
  return negated;
}

/// The rounding error of the product of the first digits is found by one fused multiply-add.
inline WideDouble operator*(const WideDouble& a, const WideDouble& b)
{
  const double product = a.high * b.high;
  const double error = std::fma(a.high, b.high, -product);
  return {product, error + (a.high * b.low + a.low * b.high), a.exponent + b.exponent};
}

/// The rounding error of the sum of the first digits is found by subtracting both again.
inline WideDouble operator+(const WideDouble& a, const WideDouble& b)
{
  if (a.high == 0 || b.high == 0)
  {
    return a.high == 0 ? b : a;
  }
  const bool a_leads = a.exponent >= b.exponent;
  const WideDouble& large = a_leads ? a : b;
  const WideDouble& small = a_leads ? b : a;
  const int shift = small.exponent - large.exponent;
  const double high = std::ldexp(small.high, shift), sum = large.high + high;
  const double part = sum - large.high;
  const double error = (large.high - (sum - part)) + (high - part);
  return {sum, error + (large.low + std::ldexp(small.low, shift)), large.exponent};
}

/// A difference is the sum with the other sign.
inline WideDouble operator-(const WideDouble& a, const WideDouble& b)
{
  return a + -b;
}

/// A first quotient, and a second one for what the first leaves over; the divisor is not zero.
inline WideDouble operator/(const WideDouble& a, const WideDouble& b)
{
  const WideDouble first(a.high / b.high, 0, a.exponent - b.exponent);
  const WideDouble rest = a - first * b;
  return first + WideDouble(rest.high / b.high, 0, rest.exponent - b.exponent);
}
// [wide_double]

/// Adds, for Eigen's sums.
inline WideDouble& operator+=(WideDouble& a, const WideDouble& b)
{
  return a = a + b;
}

/// The number without its sign.
inline WideDouble abs(const WideDouble& a)
{
  return a.high < 0 ? -a : a;
}

/// Whether a number is at most another one.
inline bool operator<=(const WideDouble& a, const WideDouble& b)
{
  return (a - b).high <= 0;
}

} // namespace cookbook

/// What Eigen must know of a number type to put it into a matrix.
template <>
struct Eigen::NumTraits<cookbook::WideDouble> : Eigen::GenericNumTraits<cookbook::WideDouble>
{
  enum
  {
    IsSigned = 1 // or else Eigen takes each number for its own absolute value
  };
};
