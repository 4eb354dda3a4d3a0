#pragma once

/// \file
/// \brief Bounds to ask which may touch, and the answer that asks every pair.

#include "05_resolution/contacts/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cookbook
{

// [every_pair]
/// What `overlapping_pairs` is to find, by asking every pair.
inline std::vector<std::pair<int, int>> every_overlapping_pair(const std::vector<Bounds>& bounds)
{
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    for (std::size_t j = i + 1; j < bounds.size(); ++j)
    {
      if (bounds[i].box.intersects(bounds[j].box))
      {
        pairs.push_back(std::minmax(bounds[i].body, bounds[j].body));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}
// [every_pair]

/// A square grid of boxes of 1 m, each 1 cm into its neighbours; row L6.
inline std::vector<Bounds> grid_bounds(int count)
{
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<Bounds> bounds;
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> middle(0.99 * (i % side), 0, 0.99 * (i / side));
    const Vector3<double> half = Vector3<double>::Constant(0.5);
    bounds.push_back({{middle - half, middle + half}, i});
  }
  return bounds;
}

} // namespace cookbook
