#pragma once

/// \file
/// \brief Ways to normalise that libraries offer, on the vectors that break some way.

#include "01_math/normalize/trial/normalize_cases.hpp"

#include <array>
#include <vector>

namespace cookbook
{

/// Eigen's two functions, and a division by the standard library's length.
template <class Real>
std::array<NormalizeMethod<Real>, 3> normalize_libraries()
{
  using Three = Vector3<Real>;
  return {
      {{"normalized",
        [](const Three& v) {
          return Direction<Real>{v.normalized(), v.norm()};
        }},
       {"stableNormalized",
        [](const Three& v) {
          return Direction<Real>{v.stableNormalized(), v.stableNorm()};
        }},
       {"hypot", normalize_hypot<Real>}}};
}

/// The verdicts on these ways, case by case.
template <class Real>
std::vector<VerdictRow> library_verdicts(const std::vector<NormalizeCase<Real>>& cases)
{
  std::vector<VerdictRow> rows;
  for (const NormalizeCase<Real>& one : cases)
  {
    rows.push_back({one.id, one.what, {}});
    for (const NormalizeMethod<Real>& method : normalize_libraries<Real>())
    {
      const Direction<Real> answer = method.normalize(one.v);
      Verdict verdict = normalize_verdict(answer, one.v);
      if (!verdict.holds && answer.unit.allFinite() && answer.unit.norm() < Real(0.5))
      {
        verdict.what = "the direction is 0";
      }
      rows.back().verdicts.push_back(verdict);
    }
  }
  return rows;
}

} // namespace cookbook
