#pragma once

/// \file
/// \brief Ways to add many numbers: one after the other, in pairs, and with what was lost.

#include "01_math/sums/sum_compensated.hpp"
#include "common/math/wide.hpp"

#include <cstddef>
#include <span>

namespace cookbook
{

// [sum_naive]
/// Adds from first to last: n − 1 roundings for the first number.
template <class Real>
Real sum_naive(std::span<const Real> numbers)
{
  Real sum = 0;
  for (const Real x : numbers)
  {
    sum += x;
  }
  return sum;
}
// [sum_naive]

// [sum_wide]
/// Adds floats in double, and rounds once; a double has nothing wider.
template <class Real>
Real sum_wide(std::span<const Real> numbers)
{
  Wide<Real> sum = 0;
  for (const Real x : numbers)
  {
    sum += Wide<Real>(x);
  }
  return static_cast<Real>(sum);
}
// [sum_wide]

// [sum_pairwise]
/// Adds the two halves, each added in the same way; up to 128 numbers in 16 columns.
///
/// No number goes through more than 8 + 4 + ⌈log₂(n / 128)⌉ roundings. The columns do not wait for
/// each other, so that a processor adds several at once.
template <class Real>
Real sum_pairwise(std::span<const Real> numbers)
{
  constexpr std::size_t columns = 16, block = 128;
  if (numbers.size() > block)
  {
    const std::size_t half = (numbers.size() / 2 + block - 1) / block * block;
    return sum_pairwise(numbers.first(half)) + sum_pairwise(numbers.subspan(half));
  }
  Real sums[columns] = {};
  const std::size_t whole = numbers.size() / columns * columns;
  for (std::size_t i = 0; i < whole; i += columns)
  {
    for (std::size_t j = 0; j < columns; ++j)
    {
      sums[j] += numbers[i + j];
    }
  }
  for (std::size_t i = whole; i < numbers.size(); ++i)
  {
    sums[i - whole] += numbers[i];
  }
  for (std::size_t left = columns / 2; left > 0; left /= 2)
  {
    for (std::size_t j = 0; j < left; ++j)
    {
      sums[j] += sums[j + left];
    }
  }
  return sums[0];
}
// [sum_pairwise]

// [sum_kahan]
/// Adds to each number what the addition before it lost; fails where a number is larger than the
/// sum so far.
template <class Real>
Real sum_kahan(std::span<const Real> numbers)
{
  Real sum = 0, lost = 0;
  for (const Real x : numbers)
  {
    const Real with_lost = x + lost;
    const Real next = sum + with_lost;
    lost = with_lost - (next - sum);
    sum = next;
  }
  return sum;
}
// [sum_kahan]

} // namespace cookbook
