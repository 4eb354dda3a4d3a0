#pragma once

/// \file
/// \brief Which quarter of a turn an angle is next to, and how far it is from there.

#include <cmath>
#include <cstdint>
#include <limits>

namespace cookbook
{

/// A sum of two numbers with what rounding took from it.
struct RoundedSum
{
  double high; ///< a + b, rounded
  double low;  ///< the rest, exactly
};

/// Adds two numbers without loss. Source: Knuth, The Art of Computer Programming, vol. 2, 4.2.2.
inline RoundedSum two_sum(double a, double b)
{
  const double high = a + b, of_b = high - a;
  return {high, (a - (high - of_b)) + (b - of_b)};
}

// [quarter_turns]
/// An angle as a number of quarter turns and a rest of π/4 [rad] at most, in two parts.
struct QuarterTurns
{
  int count;   ///< of quarter turns, modulo 4
  double high; ///< [rad] the rest, rounded
  double low;  ///< [rad] what rounding took from it
};

/// π/2 in two parts: together 107 bits of it.
inline constexpr double quarter_high = 0x1.921fb54442d18p+0, quarter_low = 0x1.1a62633145c07p-54;

/// The quarter turns in an angle [rad] of less than 2²⁰.
///
/// With k = 2^20 of them the rest is right to 2^-90: π/2 is split, and each product is exact, as is
/// the difference from the angle, which has no finer digits than 2^-52 if it is more than 1/2.
inline QuarterTurns quarter_turns_of_near(double angle)
{
  const double count = std::floor(angle / quarter_high + 0.5);
  const double rest = std::fma(-count, quarter_high, angle), second = count * quarter_low;
  const RoundedSum sum = two_sum(rest, -second);
  return {static_cast<int>(count) & 3, sum.high, sum.low - std::fma(count, quarter_low, -second)};
}
// [quarter_turns]

// [far_turns]
/// The digits of 2/π to the base 2³² behind the point: as many as the largest double needs.
inline constexpr std::uint32_t two_over_pi[36] = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08};

/// The quarter turns in an angle [rad] of 1 or more, however large, taken as exact.
///
/// Multiplies it by 2/π as it is done on paper, and leaves out what makes whole turns.
/// Source: Payne and Hanek 1983, Radian reduction for trigonometric functions.
inline QuarterTurns quarter_turns_of_far(double angle)
{
  const int place = std::ilogb(angle) / 32;
  double rest = std::ldexp(angle, -32 * place);
  std::uint64_t factor[3]; // the angle's own digits, the first of them with the weight 2^(32 place)
  for (std::uint64_t& digit : factor)
  {
    digit = static_cast<std::uint64_t>(rest);
    rest = (rest - static_cast<double>(digit)) * 0x1p32;
  }
  std::uint64_t digits[6],
      carry = 0; // the product: the last digit before the point, and five behind it
  for (int d = 5; d >= 0; --d)
  {
    std::uint64_t low = carry, high = 0;
    for (int j = place + d > 3 ? 0 : 3 - place - d; j < 3; ++j)
    {
      const std::uint64_t product = factor[2 - j] * two_over_pi[place + d - 3 + j];
      low += product & 0xffffffff;
      high += product >> 32;
    }
    digits[d] = low & 0xffffffff;
    carry = (low >> 32) + high;
  }
  // More than half a quarter turn is less than none of the next.
  std::uint64_t first = digits[1] << 32 | digits[2], then = digits[3] << 32 | digits[4];
  const std::uint64_t next = first >> 63;
  first = next != 0 ? ~first : first;
  then = next != 0 ? ~then : then;
  const double fine = static_cast<double>((first & 2047) << 53 | then >> 11) * 0x1p-117;
  const RoundedSum part = two_sum(static_cast<double>(first >> 11) * 0x1p-53, fine);
  const double sign = next != 0 ? -1 : 1, radians = part.high * quarter_high;
  const double low = std::fma(part.high, quarter_high, -radians) + part.high * quarter_low +
                     part.low * quarter_high;
  return {static_cast<int>((digits[0] + next) & 3), sign * radians, sign * low};
}
// [far_turns]

/// The quarter turns in an angle [rad]; the rest of what is infinite or not a number is not a
/// number.
inline QuarterTurns quarter_turns(double angle)
{
  const double size = std::abs(angle);
  if (size < 0x1p20)
  {
    return quarter_turns_of_near(angle);
  }
  if (!(size <= std::numeric_limits<double>::max()))
  {
    return {0, angle - angle, 0};
  }
  const QuarterTurns turns = quarter_turns_of_far(size);
  return angle < 0 ? QuarterTurns{-turns.count & 3, -turns.high, -turns.low} : turns;
}

} // namespace cookbook
