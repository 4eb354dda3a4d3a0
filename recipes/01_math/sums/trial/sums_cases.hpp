#pragma once

/// \file
/// \brief Ways to add many numbers, and the numbers that break them.

#include "01_math/sums/sums.hpp"
#include "01_math/sums/trial/eigen_sum.hpp"
#include "common/math/ulp.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to add, by name.
template <class Real>
struct SumMethod
{
  std::string name;                   ///< as on the page
  Real (*sum)(std::span<const Real>); ///< the way
};

/// The ways that compete, the recommended one last.
template <class Real>
std::array<SumMethod<Real>, 6> sum_methods()
{
  return {
      {{"naive", sum_naive<Real>},
       {"Eigen", sum_eigen},
       {"pairwise", sum_pairwise<Real>},
       {"wider", sum_wide<Real>},
       {"Kahan", sum_kahan<Real>},
       {"compensated", sum_compensated<Real>}}};
}

/// Numbers, and the representable number nearest to their sum, by hand.
template <class Real>
struct SumCase
{
  std::string what;          ///< as text
  std::vector<Real> numbers; ///< to be added, in this order
  Real right;                ///< the sum
};

/// A first number, and then others that are all alike.
template <class Real>
std::vector<Real> one_and_many(Real first, std::size_t count, Real other)
{
  std::vector<Real> numbers(count + 1, other);
  numbers[0] = first;
  return numbers;
}

// [sum_cases]
/// Floats to add.
inline std::vector<SumCase<float>> sum_cases(float)
{
  const float most = std::numeric_limits<float>::max(), step = 1.0f / 60;
  std::vector<float> hundred;
  for (int i = 1; i <= 100; ++i)
  {
    hundred.push_back(static_cast<float>(i));
  }
  return {
      {"1 to 100", hundred, 5050},
      {"2^24 and 1000 ones", one_and_many(0x1p24f, 1000, 1.0f), 0x1p24f + 1000},
      {"an hour of 1/60 s", std::vector<float>(216000, step),
       static_cast<float>(216000 * static_cast<double>(step))},
      {"1, 1e30, 1, −1e30", {1, 1e30f, 1, -1e30f}, 2},
      {"largest, 0, largest, −largest", {most, 0, most, -most}, most}};
}

/// Doubles to add.
inline std::vector<SumCase<double>> sum_cases(double)
{
  return {
      {"1 and 4096 times 2^-53", one_and_many(1.0, 4096, 0x1p-53), 1 + 0x1p-41},
      {"1, 1e100, 1, −1e100", {1, 1e100, 1, -1e100}, 2},
      {"1, 1e100, −1e100, 1", {1, 1e100, -1e100, 1}, 2},
      {"1e200, 1e100, 1, −1e200, −1e100", {1e200, 1e100, 1, -1e200, -1e100}, 1}};
}
// [sum_cases]

/// An answer is right within four ulps.
inline constexpr double allowed_sum_ulps = 4;

/// How far off a sum is [ulp of the right one]; infinite where it is no number.
template <class Real>
double sum_error(Real answer, Real right)
{
  const Real error = std::abs(answer - right);
  return std::isfinite(error) ? static_cast<double>(error / ulp(right / 2) / 2)
                              : std::numeric_limits<double>::infinity();
}

/// The verdicts on all ways, case by case.
template <class Real>
std::vector<VerdictRow> sum_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const SumCase<Real>& one : sum_cases(Real()))
  {
    rows.push_back({"", one.what, {}, number(static_cast<double>(one.right))});
    for (const SumMethod<Real>& method : sum_methods<Real>())
    {
      const Real answer = method.sum(one.numbers);
      const double error = sum_error(answer, one.right);
      const bool right = error <= allowed_sum_ulps;
      const std::string what = right                   ? "right"
                               : !std::isfinite(error) ? "no number"
                               : error < 1e6           ? rounded(error) + " ulp off"
                                             : "says " + number(static_cast<double>(answer));
      rows.back().verdicts.push_back({right, what});
    }
  }
  return rows;
}

} // namespace cookbook
