#pragma once

/// \file
/// \brief Named workloads of vectors, and how wrong a way to normalise is on each.

#include "01_math/normalize/trial/normalize_cases.hpp"
#include "tools/measure/statistics.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

// [normalize_workload]
/// Vectors of every power of ten from `least` to `most`, a few of each size, in turns.
inline std::vector<Vector3<float>> normalize_workload(int least, int most)
{
  std::vector<Vector3<float>> all;
  for (int turn = 0; turn < 2000; ++turn)
  {
    const int exponent = least + (5 * turn) % (most - least + 1);
    const float size = static_cast<float>(std::pow(10.0, exponent));
    all.push_back(vectors_of_size(size, 1 + turn % 20).back());
  }
  return all;
}

/// From a millimetre to a kilometre.
inline std::vector<Vector3<float>> room_vectors()
{
  return normalize_workload(-3, 3);
}

/// From the smallest to the largest float.
inline std::vector<Vector3<float>> all_vectors()
{
  return normalize_workload(-44, 38);
}
// [normalize_workload]

/// How wrong a way is on a workload; infinitely where it loses a length or a direction.
inline measure::ErrorStatistics
normalize_errors(const NormalizeMethod<float>& method, const std::vector<Vector3<float>>& vectors)
{
  std::vector<double> errors;
  for (const Vector3<float>& v : vectors)
  {
    const Direction<float> answer = method.normalize(v);
    const bool lost = answer.length == 0 && !v.isZero(0);
    errors.push_back(lost ? std::numeric_limits<double>::infinity() : direction_error(answer, v));
  }
  return measure::error_statistics(errors);
}

} // namespace cookbook
