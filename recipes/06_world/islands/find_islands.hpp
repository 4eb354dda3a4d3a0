#pragma once

/// \file
/// \brief Islands: movable bodies that hang together by contacts.

#include "06_world/contacts/pair_order.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [islands]
/// Writes the island of every body: the lowest number of all bodies that hang together with it by
/// contacts between movable bodies; −1 for a body that cannot move, which joins none.
///
/// `moves(i)` says whether a body can. Lists of `pairs` say which two bodies touch or are joined,
/// by pair_of(); their order changes nothing.
template <class Moves, class... Pairs>
void find_islands(std::vector<int>& island_of, const Moves& moves, const Pairs&... pairs)
{
  std::iota(island_of.begin(), island_of.end(), 0);
  const auto up = [&](int i) -> int& { return island_of[static_cast<std::size_t>(i)]; };
  const auto root = [&](int i)
  {
    while (up(i) != i)
    {
      i = up(i) = up(up(i));
    }
    return i;
  };
  const auto join_all = [&](const auto& list)
  {
    for (const auto& one : list)
    {
      const auto [a, b] = pair_of(one);
      if (moves(a) && moves(b))
      {
        const int root_a = root(a), root_b = root(b);
        up(std::max(root_a, root_b)) = std::min(root_a, root_b);
      }
    }
  };
  (join_all(pairs), ...);
  for (int i = 0; i < static_cast<int>(island_of.size()); ++i)
  {
    up(i) = moves(i) ? root(i) : -1;
  }
}

/// The island of every body.
inline std::vector<int>
islands(const std::vector<bool>& movable, std::span<const std::pair<int, int>> pairs)
{
  std::vector<int> island_of(movable.size());
  find_islands(
      island_of, [&](int i) { return movable[static_cast<std::size_t>(i)]; }, pairs);
  return island_of;
}
// [islands]

} // namespace cookbook
