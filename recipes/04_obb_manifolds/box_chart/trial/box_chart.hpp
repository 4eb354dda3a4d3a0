#pragma once

/// \file
/// \brief What the chart of methods for two boxes says in words and tables.

#include "04_obb_manifolds/box_oracles/trial/method_times.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// What the methods get wrong.
inline Cells errors_table(const std::vector<MeasuredBoxMethod>& methods)
{
  Cells cells{
      {"errors", "wrong verdicts", "99 % of depths [size]", "worst depth [size]",
       "99 % of jumps [size]", "1 % of areas [1]"}};
  for (const auto& [times, accuracy, steadiness] : methods)
  {
    cells.push_back(
        {times[0].name, std::to_string(accuracy.wrong + accuracy.not_finite),
         rounded(accuracy.depth_p99), rounded(accuracy.depth_max), rounded(steadiness.jump),
         rounded(steadiness.area)});
  }
  return cells;
}

// [overlap_operations]
/// The operations that the fifteen overlaps of a pair take: each +, − and ×.
///
/// B as A sees it: 9 entries of 5, an offset of 3, twice 3 of 5; 6 faces of 7; 9 edge axes of 14.
inline constexpr int overlap_operations = (9 * 5 + 3 + 2 * 3 * 5) + 6 * 7 + 9 * 14;
// [overlap_operations]

/// A decision [ns a pair] beside the peak of its core [ns an operation].
inline std::vector<std::string> peak_row(const std::string& name, double ns, double peak_ns)
{
  const double rate = overlap_operations / ns;
  return {
      name, measure::time_text(ns), rounded(rate), rounded(1 / peak_ns),
      rounded(100 * rate * peak_ns) + " %"};
}

} // namespace cookbook
