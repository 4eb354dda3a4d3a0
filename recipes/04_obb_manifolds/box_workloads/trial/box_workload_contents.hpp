#pragma once

/// \file
/// \brief What a workload of pairs of boxes consists of: how many overlap, how deep, and by what.

#include "04_obb_manifolds/box_workloads/trial/box_overlap_truth.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace cookbook
{

/// What the pairs of a workload are like.
struct BoxContents
{
  std::size_t parallel = 0;   ///< pairs with a face of A and one of B parallel within 1°
  std::size_t edges = 0;      ///< pairs that overlap less along an edge axis than along any face's
  std::vector<double> depths; ///< of pairs that overlap, as parts of the pair's size
};

/// The least overlap [m] along the normals of the faces of both boxes.
inline double least_along_faces(const Obb<double>& a, const Obb<double>& b)
{
  double least = std::numeric_limits<double>::max();
  for (const Obb<double>& box : {a, b})
  {
    for (const Vector3<double>& normal : box.axes.colwise())
    {
      least = std::min(
          {least, overlap_along<double>(a, b, normal), overlap_along<double>(a, b, -normal)});
    }
  }
  return least;
}

/// Counts what a workload consists of; an edge axis counts from a millionth of the size on.
inline BoxContents contents(const BoxWorkload& workload)
{
  BoxContents contents;
  for (const BoxPair<float>& pair : workload.pairs)
  {
    const Obb<double> a = orthonormal(pair.first), b = orthonormal(pair.second);
    const TrueLeast<double> least = true_least_overlap(a, b);
    contents.parallel += has_parallel_faces(a, b) ? 1 : 0;
    const double depth = true_depth(least);
    if (depth >= 0)
    {
      contents.depths.push_back(depth / pair_size(a, b));
      const double tolerance = 1e-6 * pair_size(a, b);
      contents.edges += depth < least_along_faces(a, b) - tolerance ? 1 : 0;
    }
  }
  return contents;
}

} // namespace cookbook
