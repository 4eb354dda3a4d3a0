#pragma once

/// \file
/// \brief The sum of many numbers with a second sum of all that its roundings took away.

#include <cmath>
#include <cstddef>
#include <span>

namespace cookbook
{

// [running_sum]
/// A sum that numbers are added to one by one, with what the additions lost beside it; Neumaier.
///
/// Of the two numbers that are added, the digits of the smaller one are lost.
template <class Real>
struct RunningSum
{
  Real sum = 0;  ///< rounded
  Real lost = 0; ///< what the roundings took away

  /// Adds a number.
  void add(Real x)
  {
    const Real next = sum + x;
    const bool sum_is_larger = std::abs(sum) >= std::abs(x);
    lost += sum_is_larger ? (sum - next) + x : (x - next) + sum;
    sum = next;
  }

  /// The sum of all numbers so far.
  Real value() const { return sum + lost; }
};
// [running_sum]

// [sum_columns]
/// Adds numbers, each times a power of two, in 16 columns, each with what it lost beside it.
///
/// The rounding of a sum is found without asking which number is larger (Knuth).
template <class Real>
Real sum_columns(std::span<const Real> numbers, Real power)
{
  constexpr std::size_t columns = 16;
  Real sums[columns] = {}, lost[columns] = {};
  const std::size_t whole = numbers.size() / columns * columns;
  for (std::size_t i = 0; i < whole; i += columns)
  {
    for (std::size_t j = 0; j < columns; ++j)
    {
      const Real x = numbers[i + j] * power, sum = sums[j], next = sum + x, added = next - sum;
      lost[j] += (sum - (next - added)) + (x - added);
      sums[j] = next;
    }
  }
  RunningSum<Real> total;
  for (std::size_t i = whole; i < numbers.size(); ++i)
  {
    total.add(numbers[i] * power);
  }
  for (const Real& sum : sums)
  {
    total.add(sum);
  }
  for (const Real& one : lost)
  {
    total.add(one);
  }
  return total.value();
}
// [sum_columns]

// [sum_compensated]
/// The sum of any finite numbers: off by u|sum| + γₙ² of the sum of their sizes, whatever the
/// order; infinite only where the true answer does not fit.
///
/// No numbers add up to 0. Infinite and NaN input gives what `sum_naive` gives.
template <class Real>
Real sum_compensated(std::span<const Real> numbers)
{
  const Real sum = sum_columns(numbers, Real(1));
  if (std::isfinite(sum))
  {
    return sum;
  }
  Real plain = 0;
  bool given = true;
  for (const Real x : numbers)
  {
    plain += x;
    given = given && std::isfinite(x);
  }
  // Divided by more than their count, no numbers overflow on the way.
  const int exponent = std::ilogb(static_cast<double>(numbers.size())) + 2;
  return given ? std::ldexp(sum_columns(numbers, std::ldexp(Real(1), -exponent)), exponent) : plain;
}
// [sum_compensated]

} // namespace cookbook
