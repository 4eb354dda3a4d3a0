#pragma once

/// \file
/// \brief How good a method's manifolds are on a workload: percentiles and counts of their errors.

#include "04_obb_manifolds/box_oracles/trial/manifold_error.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "tools/measure/statistics.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

/// How good a method is on a workload.
struct WorkloadQuality
{
  std::size_t overlapping = 0; ///< pairs that overlap in truth
  std::size_t wrong = 0;       ///< verdicts, by more than 1e-5 of the pair's size
  std::size_t not_finite = 0;  ///< manifolds with a NaN, an infinity or without a point
  std::size_t compared = 0;    ///< manifolds of pairs without faces parallel within 1°
  double excess = 0;           ///< [1], of those, as part of the least overlap; 99th percentile
  double excess_of_size = 0;   ///< [1], of those, as part of the pair's size; 99th percentile
  double excess_tolerated = 0; ///< [1], of those, in units of what is tolerated; 99th percentile
  double said = 0;             ///< [1], depth against overlap along the normal, of size; largest
  double outside = 0;          ///< [1], of any point beyond half the depth, of size; largest
};

/// What of an excess is tolerated: the larger of a part of the overlap and a part of the size.
struct ExcessTolerance
{
  double of_depth; ///< [1]
  double of_size;  ///< [1]
};

/// The 99th percentile; zero where there is none to compare.
inline double p99(const std::vector<double>& errors)
{
  return errors.empty() ? 0 : measure::error_statistics(errors).p99;
}

/// Sums up errors.
inline WorkloadQuality
summed_up(const std::vector<ManifoldError>& errors, const ExcessTolerance& tolerance)
{
  WorkloadQuality quality;
  std::vector<double> of_depth, of_size, tolerated;
  for (const ManifoldError& error : errors)
  {
    quality.overlapping += error.depth >= 0 ? 1 : 0;
    quality.wrong += error.wrong(1e-5) ? 1 : 0;
    quality.not_finite += error.finite ? 0 : 1;
    if (!error.answered || !error.finite)
    {
      continue;
    }
    quality.said = std::max(quality.said, std::abs(error.said) / error.size);
    quality.outside = std::max(quality.outside, error.outside / error.size);
    if (!error.parallel && error.depth > 0)
    {
      of_depth.push_back(error.excess / error.depth);
      of_size.push_back(error.excess / error.size);
      tolerated.push_back(
          error.excess /
          std::max(tolerance.of_depth * error.depth, tolerance.of_size * error.size));
    }
  }
  quality.compared = of_depth.size();
  quality.excess = p99(of_depth);
  quality.excess_of_size = p99(of_size);
  quality.excess_tolerated = p99(tolerated);
  return quality;
}

/// How good `method(a, b)` is on a workload, in the number type `Real`.
template <class Real, class Method>
WorkloadQuality workload_quality(
    const BoxWorkload& workload, const Method& method, const ExcessTolerance& tolerance)
{
  std::vector<ManifoldError> errors;
  errors.reserve(workload.pairs.size());
  for (const BoxPair<float>& pair : workload.pairs)
  {
    const BoxPair<Real> seen = pair_in<Real>(pair);
    errors.push_back(manifold_error(seen, method(seen.first, seen.second)));
  }
  return summed_up(errors, tolerance);
}

} // namespace cookbook
