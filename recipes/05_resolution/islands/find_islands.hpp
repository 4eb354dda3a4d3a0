#pragma once

/// \file
/// \brief Islands: movable bodies that hang together by contacts.

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [islands]
/// The island of every body: the lowest number of all bodies that hang together with it by contacts
/// between movable bodies; −1 for a body that cannot move, which joins none.
///
/// `pairs` are the numbers of two bodies that touch. Their order changes nothing.
inline std::vector<int>
islands(const std::vector<bool>& movable, std::span<const std::pair<int, int>> pairs)
{
  std::vector<int> parent(movable.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto up = [&](int i) -> int& { return parent[static_cast<std::size_t>(i)]; };
  const auto root = [&](int i)
  {
    while (up(i) != i)
    {
      i = up(i) = up(up(i));
    }
    return i;
  };
  const auto moves = [&](int i) { return movable[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b] : pairs)
  {
    if (moves(a) && moves(b))
    {
      const int root_a = root(a), root_b = root(b);
      up(std::max(root_a, root_b)) = std::min(root_a, root_b);
    }
  }
  for (int i = 0; i < static_cast<int>(parent.size()); ++i)
  {
    up(i) = moves(i) ? root(i) : -1;
  }
  return parent;
}
// [islands]

} // namespace cookbook
