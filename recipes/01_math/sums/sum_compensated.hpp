#pragma once

/// \file
/// \brief The sum of many numbers in two parts: rounded, and what the roundings took away.

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace cookbook
{

// [running_sum]
/// A sum in two parts, to which numbers are added one by one; or a row of sums, where `Value` is a
/// row of numbers.
template <class Value>
struct RunningSum
{
  Value sum{};  ///< rounded
  Value lost{}; ///< what the roundings took away, at most half an ulp of `sum`

  /// Adds a number, or a row of numbers.
  void add(const Value& x)
  {
    // What the addition rounds away, exactly, whichever of the two is larger (Knuth).
    const Value next = sum + x;
    const Value added = next - sum;
    const Value rounding = (sum - (next - added)) + (x - added);
    // Move all digits that fit from the second part into the first.
    const Value all_lost = lost + rounding;
    sum = next + all_lost;
    lost = all_lost - (sum - next);
  }
};
// [running_sum]

// [sum_columns]
/// Adds numbers, each times a power of two, in columns of which a processor adds several at once.
template <class Real>
Real sum_columns(std::span<const Real> numbers, Real power)
{
  constexpr std::size_t columns = 64 / sizeof(Real);
  using Row = Eigen::Array<Real, static_cast<int>(columns), 1>;
  RunningSum<Row> rows{Row::Zero(), Row::Zero()};
  RunningSum<Real> total;
  std::size_t i = 0;
  for (; i + columns <= numbers.size(); i += columns)
  {
    rows.add(Eigen::Map<const Row>(numbers.data() + i) * power);
  }
  for (; i < numbers.size(); ++i)
  {
    total.add(numbers[i] * power);
  }
  for (const Row& part : {rows.sum, rows.lost})
  {
    for (const Real x : part)
    {
      total.add(x);
    }
  }
  return total.sum;
}
// [sum_columns]

// [sum_compensated]
/// The sum of any finite numbers, off by at most u|sum| + 4(n + 32)u² of the sum of their sizes,
/// whatever the order; infinite only where the true answer does not fit.
///
/// No numbers add up to 0. Infinite and NaN input gives what adding them one by one gives.
template <class Real>
Real sum_compensated(std::span<const Real> numbers)
{
  const Real sum = sum_columns(numbers, Real(1));
  if (std::isfinite(sum))
  {
    return sum;
  }
  Real infinite = 0;
  for (const Real x : numbers)
  {
    infinite += std::isfinite(x) ? Real(0) : x;
  }
  if (infinite != Real(0))
  {
    return infinite;
  }
  // Divided by more than their count, numbers do not overflow on the way.
  const int exponent = std::ilogb(static_cast<double>(numbers.size())) + 2;
  return std::ldexp(sum_columns(numbers, std::ldexp(Real(1), -exponent)), exponent);
}
// [sum_compensated]

} // namespace cookbook
