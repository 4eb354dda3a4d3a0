#pragma once

/// \file
/// \brief Pairs of boxes with their truth, to test the published code against.

#include "04_obb_manifolds/box_as_published/trial/box_as_published.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

/// A pair with its truth.
struct CheckedPair
{
  Obb<double> a, b;                    ///< axes orthonormal to double's rounding
  double depth;                        ///< [m], less than zero where apart
  Vector3<double> normal;              ///< [1], with all faults mended
  std::vector<Vector3<double>> points; ///< [m], with all faults mended; none where not asked for
};

/// The pair with the points of the mended code, or without points.
inline CheckedPair judged(const Obb<double>& a, const Obb<double>& b, double depth, bool asked)
{
  CheckedPair pair{a, b, depth, Vector3<double>::Zero(), {}};
  if (asked)
  {
    const auto mended = box_as_published(a, b, no_faults).value();
    pair.normal = mended.normal;
    for (const ContactPoint<double>& point : mended.points)
    {
      pair.points.push_back(point.position);
    }
  }
  return pair;
}

/// Boxes of metres, boxes that rest, and boxes of millimetres, a third each, without pairs that
/// rounding could decide; points are asked for of every eighth.
inline std::vector<CheckedPair> checked_pairs(std::size_t count)
{
  std::vector<CheckedPair> pairs;
  for (const char* const name : {"random", "resting", "millimetres"})
  {
    for (const auto& [float_a, float_b] : box_workload(name, count / 3).pairs)
    {
      const Obb<double> a = orthonormal(float_a), b = orthonormal(float_b);
      const double depth = true_depth(true_least_overlap(a, b));
      if (std::abs(depth) > 1e-9 * pair_size(a, b))
      {
        pairs.push_back(judged(a, b, depth, depth > 0 && pairs.size() % 8 == 0));
      }
    }
  }
  return pairs;
}

/// Whether a mended point has none within a fiftieth of the boxes' size, seen along the normal.
inline bool
lacks_point(const CheckedPair& pair, const Manifold<double, most_published_points>& found)
{
  const double close_by = pair_size(pair.a, pair.b) / 50;
  const auto has = [&](const Vector3<double>& point)
  {
    return std::any_of(
        found.points.begin(), found.points.end(),
        [&](const ContactPoint<double>& other)
        { return (other.position - point).cross(pair.normal).norm() <= close_by; });
  };
  return !std::all_of(pair.points.begin(), pair.points.end(), has);
}

} // namespace cookbook
