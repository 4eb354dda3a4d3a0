#pragma once

/// \file
/// \brief Lists of a million floats whose sums are known exactly, and how far off a way to add is.

#include "01_math/sums/trial/sums_cases.hpp"
#include "tools/measure/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

/// Numbers to add, and the exact sum as a multiple of 2^-40.
struct SumList
{
  std::vector<float> numbers; ///< each a multiple of 2^-40, below one
  std::int64_t sum = 0;       ///< exact

  /// Adds a multiple of 2^-40 to the list.
  void add(std::int64_t units)
  {
    numbers.push_back(std::ldexp(static_cast<float>(units), -40));
    sum += units;
  }
};

/// What the signs of the numbers are.
enum class Signs
{
  positive, ///< all are positive
  random,   ///< as many are negative
  opposite  ///< nearly every number has its opposite in the list
};

// [sum_list]
/// A million floats of 16 sizes in random order, the same ones for the same seed.
inline SumList sum_list(Signs signs, unsigned seed)
{
  std::mt19937 random(seed);
  SumList list;
  while (list.numbers.size() < 1000000)
  {
    const std::int64_t digits = random() % (1 << 24), units = digits << random() % 16;
    const bool opposite = signs == Signs::opposite && list.numbers.size() < 999980;
    const bool negative = signs == Signs::random && random() % 2 == 0;
    list.add(negative ? -units : opposite || signs != Signs::opposite ? units : digits);
    if (opposite)
    {
      list.add(-units);
    }
  }
  std::shuffle(list.numbers.begin(), list.numbers.end(), random);
  return list;
}
// [sum_list]

/// How far a way to add is off [ulp of the exact sum]: the median and the largest of some lists.
inline measure::ErrorStatistics
sum_errors(const SumMethod<float>& method, const std::vector<SumList>& lists)
{
  std::vector<double> errors;
  for (const SumList& list : lists)
  {
    // Two multiples of 2^-40: their difference is exact in double, for both have at most 53 digits.
    const double truth = std::ldexp(static_cast<double>(list.sum), -40);
    const double off = std::abs(static_cast<double>(method.sum(list.numbers)) - truth);
    errors.push_back(off / static_cast<double>(ulp(static_cast<float>(truth))));
  }
  return {measure::median(errors), *std::max_element(errors.begin(), errors.end())};
}

} // namespace cookbook
