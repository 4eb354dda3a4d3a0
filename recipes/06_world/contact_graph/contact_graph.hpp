#pragma once

/// \file
/// \brief Contacts in colours, so that no two of a colour share a body that moves.

#include "06_world/lanes/groups.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cookbook
{

// [contact_graph]
/// How many colours contacts share; what finds none of them free gets one of its own. Enough where
/// no body has more than half as many contacts.
inline constexpr int shared_colors = 64;

/// Contacts sorted by colour. Two of a colour have no movable body in common: whatever one of them
/// changes, the other does not see, so that they can be solved side by side.
class ContactGraph
{
public:
  /// Gives each pair of bodies, in their order, the first colour that no earlier pair of one of its
  /// movable bodies has. `bodies` is more than any body's number; `moves(i)` says whether one can
  /// move.
  template <class Pairs, class Moves>
  void color(std::size_t bodies, const Pairs& pairs, const Moves& moves)
  {
    taken_.assign(bodies, 0);
    colors_of_.clear();
    reserve_space(colors_of_, pairs.size());
    int own = 0;
    count_ = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const auto [a, b] = pairs[i];
      const std::uint64_t at_a = moves(a) ? taken(a) : 0, at_b = moves(b) ? taken(b) : 0;
      const int free = std::countr_one(at_a | at_b);
      const std::uint64_t bit = free < shared_colors ? std::uint64_t{1} << free : 0;
      taken(a) |= bit;
      taken(b) |= bit;
      colors_of_.push_back(free < shared_colors ? free : shared_colors + own++);
      count_ = std::max(count_, colors_of_.back() + 1);
    }
    contacts_.sort(
        static_cast<std::size_t>(count_), pairs.size(),
        [&](std::size_t i) { return colors_of_[i]; });
  }

  int colors() const { return count_; }                             ///< how many there are
  std::span<const int> color_of_each() const { return colors_of_; } ///< of each pair, from 0
  /// The pairs of a colour, the least number first.
  std::span<const int> operator[](int color) const
  {
    return contacts_[static_cast<std::size_t>(color)];
  }

private:
  std::uint64_t& taken(int body) { return taken_[static_cast<std::size_t>(body)]; }

  int count_ = 0;
  std::vector<std::uint64_t> taken_; // a bit for each colour that a body has
  std::vector<int> colors_of_;
  Groups contacts_;
};
// [contact_graph]

} // namespace cookbook
