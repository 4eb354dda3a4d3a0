#pragma once

/// \file
/// \brief The cross product with every component right, however nearly parallel the vectors are.

#include "common/math/norm.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cookbook
{

// [product_error]
/// Cuts a number into two halves of at most 26 bits each, which add up to it.
inline std::pair<double, double> halves(double a)
{
  const double shifted = 0x1.0000002p27 * a;
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

/// What rounding took from the product `p` of two doubles, exactly; not a number if it is too
/// large.
inline double product_error(double a, double b, double p)
{
#ifdef FP_FAST_FMA
  return std::fma(a, b, -p);
#else
  const auto [a_high, a_low] = halves(a);
  const auto [b_high, b_low] = halves(b);
  return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
#endif
}
// [product_error]

// [difference_of_products]
/// a b − c d where no digit of the products is below the smallest number; not a number where one
/// is too large.
inline double difference_in_range(double a, double b, double c, double d)
{
  const double p = a * b, q = c * d;
  return (p - q) + (product_error(a, b, p) - product_error(c, d, q));
}
// [difference_of_products]

// [difference_any_size]
/// a b − c d for all finite numbers, with the powers of two taken out of all four.
inline double difference_of_any_size(double a, double b, double c, double d)
{
  int of_a = 0, of_b = 0, of_c = 0, of_d = 0;
  a = std::frexp(a, &of_a), b = std::frexp(b, &of_b);
  c = std::frexp(c, &of_c), d = std::frexp(d, &of_d);
  const int first = a * b == 0 ? of_c + of_d : of_a + of_b;
  const int second = c * d == 0 ? first : of_c + of_d;
  const int larger = std::max(first, second);
  // A product that is 2^-300 of the other one is far below the last digit of the result.
  a = std::ldexp(a, std::max(first - larger, -300));
  c = std::ldexp(c, std::max(second - larger, -300));
  return std::ldexp(difference_in_range(a, b, c, d), larger);
}

/// a b − c d within 2 u of itself, or within the smallest number, for all finite numbers.
inline double difference_of_products(double a, double b, double c, double d)
{
  const auto has_all_digits = [](double x, double y)
  { return std::abs(x * y) >= SafeSquares<double>::least || x == 0 || y == 0; };
  const double answer = difference_in_range(a, b, c, d);
  const bool right = has_all_digits(a, b) && has_all_digits(c, d) && !std::isnan(answer);
  return right ? answer : difference_of_any_size(a, b, c, d);
}

/// The same for floats, whose products are exact in double.
inline float difference_of_products(float a, float b, float c, float d)
{
  return static_cast<float>(double(a) * double(b) - double(c) * double(d));
}
// [difference_any_size]

// [accurate_cross]
/// The cross product a × b, each component within 2 u of itself; M2.
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
