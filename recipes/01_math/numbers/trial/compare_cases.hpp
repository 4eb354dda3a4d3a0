#pragma once

/// \file
/// \brief Ways to compare two numbers, and the numbers that break them.

#include "01_math/numbers/numbers.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// Whether two numbers are the same, with the size of what they were computed from.
using Compare = bool (*)(float a, float b, float size);

/// The ways to compare, the recommended one last.
inline std::vector<std::pair<std::string, Compare>> compare_methods()
{
  const auto larger = [](float a, float b) { return std::max(std::abs(a), std::abs(b)); };
  static const auto relative = [larger](float a, float b) { return 1e-6f * larger(a, b); };
  return {
      {"==", [](float a, float b, float) { return a == b; }},
      {"0.005, as published", [](float a, float b, float) { return std::abs(a - b) < 0.005f; }},
      {"relative", [](float a, float b, float) { return std::abs(a - b) <= relative(a, b); }},
      {"Eigen's isApprox",
       [](float a, float b, float)
       {
         using Number = Eigen::Matrix<float, 1, 1>;
         return Number(a).isApprox(Number(b), 1e-6f);
       }},
      {"fixed and relative",
       [](float a, float b, float) { return std::abs(a - b) <= 1e-6f + relative(a, b); }},
      {"equal_to_rounding",
       [](float a, float b, float size) { return equal_to_rounding(a, b, size, 10); }}};
}

/// The names of the ways to compare.
inline std::vector<std::string> compare_names()
{
  std::vector<std::string> names;
  for (const auto& [name, compare] : compare_methods())
  {
    names.push_back(name);
  }
  return names;
}

/// Two numbers, and whether they are the same but for rounding.
struct CompareCase
{
  std::string what; ///< both numbers, as text
  float a;          ///< one
  float b;          ///< the other
  float size;       ///< of what they were computed from
  bool same;        ///< what is right
};

/// The numbers to compare, in metres.
inline std::vector<CompareCase> compare_cases()
{
  float tenths = 0;
  for (int i = 0; i < 10; ++i)
  {
    tenths += 0.1f;
  }
  const float million = 1e6f, next = 1e6f + 0.0625f;
  const float infinite = std::numeric_limits<float>::infinity();
  return {
      {"ten times 0.1, and 1", tenths, 1, 1, true},
      {"0.004 and 0", 0.004f, 0, 0.004f, false},
      {"1e6 and 1e6 + 0.0625", million, next, million, true},
      {"1e6 + 0.0625 − 1e6, and 0", next - million, 0, million, true},
      {"1e-12 and 2e-12", 1e-12f, 2e-12f, 2e-12f, false},
      {"1e-25 and 2e-25", 1e-25f, 2e-25f, 2e-25f, false},
      {"infinite and 1", infinite, 1, 1, false}};
}

/// The verdicts on all ways to compare, pair by pair.
inline std::vector<VerdictRow> compare_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const CompareCase& one : compare_cases())
  {
    rows.push_back({"", one.what + (one.same ? ": the same" : ": not the same"), {}});
    for (const auto& [name, compare] : compare_methods())
    {
      const bool same = compare(one.a, one.b, one.size);
      rows.back().verdicts.push_back({same == one.same, same ? "the same" : "not the same"});
    }
  }
  return rows;
}

} // namespace cookbook
