#pragma once

/// \file
/// \brief Bounds to ask which may touch, and the answer that asks every pair.

#include "06_world/contacts/broad_phase.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cookbook
{

/// The pairs of bodies whose bounds overlap, as a tree finds them that may have been asked before.
inline std::vector<std::pair<int, int>>
pairs_by(BroadPhase& tree, const std::vector<Bounds>& bounds)
{
  std::vector<std::pair<int, int>> pairs;
  tree.each_pair(bounds, [&](const std::pair<int, int>& pair) { pairs.push_back(pair); });
  return pairs;
}

/// The same, as a new tree finds them.
inline std::vector<std::pair<int, int>> pairs_by_tree(const std::vector<Bounds>& bounds)
{
  BroadPhase tree;
  return pairs_by(tree, bounds);
}

/// What BroadPhase is to find, by asking every pair.
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

/// The same by sorting and sweeping: all lower ends along x in order, and each body against those
/// that begin before it ends. Quick as long as few do.
inline std::vector<std::pair<int, int>> swept_pairs(std::vector<Bounds>& bounds)
{
  const auto low = [](const Bounds& one) { return one.box.min().x(); };
  std::sort(
      bounds.begin(), bounds.end(),
      [&](const Bounds& a, const Bounds& b)
      { return std::pair(low(a), a.body) < std::pair(low(b), b.body); });
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < bounds.size(); ++i)
  {
    const double end = bounds[i].box.max().x();
    for (std::size_t j = i + 1; j < bounds.size() && low(bounds[j]) <= end; ++j)
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

/// The bounds of a box of 1 m about a place [m].
inline Bounds unit_bounds(const Vector3<double>& middle, int body)
{
  const Vector3<double> half = Vector3<double>::Constant(0.5);
  return {{middle - half, middle + half}, body};
}

/// A row of boxes of 1 m along an axis, each 1 cm into the next.
inline std::vector<Bounds> row_bounds(int count, int axis)
{
  std::vector<Bounds> bounds;
  for (int i = 0; i < count; ++i)
  {
    bounds.push_back(unit_bounds(0.99 * i * Vector3<double>::Unit(axis), i));
  }
  return bounds;
}

/// A square grid of boxes of 1 m, each 1 cm into its neighbours; row L6.
inline std::vector<Bounds> grid_bounds(int count)
{
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<Bounds> bounds;
  for (int i = 0; i < count; ++i)
  {
    bounds.push_back(unit_bounds({0.99 * (i % side), 0, 0.99 * (i / side)}, i));
  }
  return bounds;
}

} // namespace cookbook
