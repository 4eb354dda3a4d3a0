#pragma once

/// \file
/// \brief Products of doubles whose difference has lost nearly all digits, and one more way to
/// subtract them, for processors without a fused multiply-add.

#include "01_math/numbers/trial/product_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace cookbook
{

/// The numbers of ad − bc.
struct Products
{
  double a, d, b, c; ///< the numbers
};

/// Whole numbers with ad − bc = 1: the identity, sheared back and forth.
inline std::vector<Products> unit_products(int count)
{
  std::mt19937_64 random(1);
  std::vector<Products> all;
  for (int i = 0; i < count; ++i)
  {
    std::int64_t a = 1, b = 0, c = 0, d = 1;
    for (int k = 0; k < 6; ++k)
    {
      const std::int64_t shear = 100 + static_cast<std::int64_t>(random() % 200);
      a += shear * b, c += shear * d;
      b += shear * a, d += shear * c;
      if (std::max({a, b, c, d}) > (std::int64_t(1) << 34))
      {
        break;
      }
    }
    all.push_back(
        {static_cast<double>(a), static_cast<double>(d), static_cast<double>(b),
         static_cast<double>(c)});
  }
  return all;
}

// [difference_split]
/// A number cut into two of at most 26 digits each (Veltkamp).
struct Halves
{
  double high; ///< the leading digits
  double low;  ///< the others
};

/// Cuts a number, of which the 2^27-fold must not overflow.
inline Halves halves(double x)
{
  const double large = 134217729 * x, high = large - (large - x);
  return {high, x - high};
}

/// xy − product, exactly, if nothing underflows (Dekker).
inline double rounding_of(double x, double y, double product)
{
  const Halves a = halves(x), b = halves(y);
  return ((a.high * b.high - product) + a.high * b.low + a.low * b.high) + a.low * b.low;
}

/// ad − bc from halves: as accurate as with a fused multiply-add, which it does without.
inline double difference_split(double a, double d, double b, double c)
{
  const double first = a * d, second = b * c;
  return (first - second) + (rounding_of(a, d, first) - rounding_of(b, c, second));
}
// [difference_split]

} // namespace cookbook
