#pragma once

/// \file
/// \brief Sine, cosine and arc tangent with the same bits from every compiler and C library.

#include "common/math/quarter_turns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace cookbook
{

/// Whether a scalar type is float or double, for which this file computes; others bring their own
/// functions.
template <class Real>
inline constexpr bool is_float_or_double =
    std::is_same_v<Real, float> || std::is_same_v<Real, double>;

/// Sine and cosine of an angle.
template <class Real>
struct SineCosine
{
  Real sine;   ///< [1]
  Real cosine; ///< [1]
};

// [sine_cosine]
/// Sine and cosine of an angle of π/4 [rad] at most, in two parts.
///
/// Taylor's series; what it leaves out is less than (π/4)¹⁹/19! < 2^-63 of the sine, and
/// (π/4)¹⁸/18! < 2^-58 of the cosine.
inline SineCosine<double> sine_cosine_of_eighth(double x, double low)
{
  const double s = x * x, half = s / 2, near_one = 1 - half;
  double odd = 1 / 355687428096000.0, even = 1 / 20922789888000.0; // 1/17!, 1/16!
  for (const double term :
       {1 / 1307674368000.0, 1 / 6227020800.0, 1 / 39916800.0, 1 / 362880.0, 1 / 5040.0, 1 / 120.0,
        1 / 6.0})
  {
    odd = term - s * odd;
  }
  for (const double term :
       {1 / 87178291200.0, 1 / 479001600.0, 1 / 3628800.0, 1 / 40320.0, 1 / 720.0, 1 / 24.0})
  {
    even = term - s * even;
  }
  // The largest term last, with what rounding took from 1 - x²/2.
  return {
      x + (low * near_one - x * s * odd),
      near_one + ((1 - near_one - half) + (s * s * even - x * low))};
}

/// Sine and cosine of an angle [rad], within an ulp of themselves, of sums and products alone.
///
/// The angle counts as exact, however large. The sine of -0 is -0; of infinity and of what is not a
/// number both are not a number. In float both are the double's, rounded.
inline SineCosine<double> sine_cosine(double angle)
{
  if (std::abs(angle) < 0x1p-27) // angle³/6 is less than half an ulp of the angle
  {
    return {angle, 1};
  }
  const QuarterTurns turns = quarter_turns(angle);
  const SineCosine<double> of = sine_cosine_of_eighth(turns.high, turns.low);
  switch (turns.count)
  {
  case 0:
    return of;
  case 1:
    return {of.cosine, -of.sine};
  case 2:
    return {-of.sine, -of.cosine};
  default:
    return {-of.cosine, of.sine};
  }
}
// [sine_cosine]

/// The same of another scalar type: of float by way of double, of others by their own functions.
template <class Real>
SineCosine<Real> sine_cosine(const Real& angle)
{
  if constexpr (is_float_or_double<Real>)
  {
    const SineCosine<double> of = sine_cosine(static_cast<double>(angle));
    return {static_cast<Real>(of.sine), static_cast<Real>(of.cosine)};
  }
  else
  {
    using std::cos, std::sin;
    return {sin(angle), cos(angle)};
  }
}

/// The sine of an angle [rad].
template <class Real>
Real sine(const Real& angle)
{
  return sine_cosine<Real>(angle).sine;
}

/// The cosine of an angle [rad].
template <class Real>
Real cosine(const Real& angle)
{
  return sine_cosine<Real>(angle).cosine;
}

// [arc_tangent]
/// arctan(k/8) [rad] in two parts, for k from 0 to 8.
inline constexpr double arc_of_eighths[9][2] = {
    {0, 0},
    {0.12435499454676144, -3.1253241424539383e-18},
    {0.24497866312686414, 1.0698755618734451e-17},
    {0.35877067027057225, -2.4623815582638635e-17},
    {0.4636476090008061, 2.2698777452961687e-17},
    {0.5585993153435624, -5.4556305485916264e-18},
    {0.6435011087932844, 1.5834785051444286e-17},
    {0.7188299996216245, -2.1478388444456983e-17},
    {0.7853981633974483, 3.061616997868383e-17}};

/// An angle in two parts: base ± arctan(y/x), for 0 ≤ y ≤ x, 1 ≤ x < 2, where the base is a number
/// of quarter turns [rad].
///
/// With the nearest k/8 to y/x, or 0 for less than 1/8, arctan(y/x) = arctan(k/8) + arctan u, where
/// u = (8y - kx)/(8x + ky) is 1/8 at most: eight terms of its series leave out less than u¹⁸/19 <
/// 2^-58.
inline double arc_from(double quarters, double sign, double y, double x)
{
  const double k = 8 * y < x ? 0 : std::floor(8 * (y / x) + 0.5);
  const double over = std::fma(-k, x, 8 * y), under = 8 * x + k * y;
  const double u = over / under, lost = std::fma(-u, under, over) / under, s = u * u;
  double series = 1 / 17.0;
  for (const double odd : {15, 13, 11, 9, 7, 5, 3})
  {
    series = 1 / odd - s * series;
  }
  series *= s;
  const double* of_k = arc_of_eighths[static_cast<int>(k)];
  const RoundedSum base = two_sum(quarters * quarter_high, sign * of_k[0]);
  const double fine = base.low + quarters * quarter_low + sign * of_k[1];
  return base.high + (sign * u + (fine + sign * (lost - u * series)));
}

/// The angle [rad] from the x axis to the point (x, y), from -π to π, within an ulp of itself: the
/// function that C calls atan2.
///
/// What is answered for zeros and infinities is C's, too: the sign of y is kept, where it is zero
/// as well; a zero or infinity counts as a very small or very large number of its sign, but (0, 0)
/// and
/// (-0, 0) lie on the x axis, and with both infinite the point lies on a diagonal.
inline double arc_tangent(double y, double x)
{
  if (std::isnan(x) || std::isnan(y))
  {
    return x + y;
  }
  double up = std::abs(y), along = std::abs(x);
  if (std::isinf(up) || std::isinf(along))
  {
    up = std::isinf(up) ? 1 : 0;
    along = std::isinf(along) ? 1 : 0;
  }
  const bool steep = up > along, back = std::signbit(x);
  const double longer = std::max(up, along), shorter = std::min(up, along);
  const int scale = longer > 0 ? -std::ilogb(longer) : 0; // keeps 8x from overflowing
  const double of_y = std::ldexp(shorter, scale), of_x = longer > 0 ? std::ldexp(longer, scale) : 1;
  const double quarters = steep ? 1 : back ? 2 : 0;
  return std::copysign(arc_from(quarters, steep == back ? 1 : -1, of_y, of_x), y);
}
// [arc_tangent]

/// The same of another scalar type: of float by way of double, of others by their own function.
template <class Real>
Real arc_tangent(const Real& y, const Real& x)
{
  if constexpr (is_float_or_double<Real>)
  {
    return static_cast<Real>(arc_tangent(static_cast<double>(y), static_cast<double>(x)));
  }
  else
  {
    using std::atan2;
    return atan2(y, x);
  }
}

} // namespace cookbook
