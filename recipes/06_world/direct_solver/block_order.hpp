#pragma once

/// \file
/// \brief In which order the bodies of an island are eliminated.

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace cookbook
{

// [ordering]
/// Whether unknowns that are eliminated in the order of their numbers fill nothing in: each is
/// coupled to at most one that comes later, as in a tower.
inline bool fill_nothing(std::size_t count, const std::vector<std::pair<int, int>>& coupled)
{
  std::vector<bool> has_later(count, false);
  for (const auto& [i, j] : coupled)
  {
    const std::size_t first = static_cast<std::size_t>(std::min(i, j));
    if (has_later[first])
    {
      return false;
    }
    has_later[first] = true;
  }
  return true;
}

/// An order of elimination of `count` unknowns that keeps the fill small, from which pairs of them
/// are coupled: that of their numbers if it fills nothing in, otherwise approximate minimum degree.
/// The k-th entry says what comes k-th.
inline std::vector<int>
elimination_order(int count, const std::vector<std::pair<int, int>>& coupled)
{
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  if (fill_nothing(numbers.size(), coupled))
  {
    return numbers;
  }
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(count) + coupled.size());
  for (int i = 0; i < count; ++i)
  {
    entries.emplace_back(i, i, 1.0);
  }
  for (const auto& [i, j] : coupled)
  {
    entries.emplace_back(i, j, 1.0);
  }
  Eigen::SparseMatrix<double> pattern(count, count);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType order;
  Eigen::AMDOrdering<int>()(pattern, order);
  return {order.indices().data(), order.indices().data() + count};
}
// [ordering]

// [filled_rows]
/// The rows below the diagonal of each column of a factor, in the order of elimination: those
/// coupled to it, and those that earlier columns fill in. `place` says when each body is
/// eliminated.
inline std::vector<std::vector<int>>
filled_rows(const std::vector<int>& place, const std::vector<std::pair<int, int>>& coupled)
{
  std::vector<std::vector<int>> rows(place.size());
  for (const auto& [i, j] : coupled)
  {
    const int a = place[static_cast<std::size_t>(i)], b = place[static_cast<std::size_t>(j)];
    rows[static_cast<std::size_t>(std::min(a, b))].push_back(std::max(a, b));
  }
  for (std::vector<int>& own : rows)
  {
    std::sort(own.begin(), own.end());
    own.erase(std::unique(own.begin(), own.end()), own.end());
    if (!own.empty())
    {
      std::vector<int>& parent = rows[static_cast<std::size_t>(own.front())];
      parent.insert(parent.end(), own.begin() + 1, own.end());
    }
  }
  return rows;
}
// [filled_rows]

} // namespace cookbook
