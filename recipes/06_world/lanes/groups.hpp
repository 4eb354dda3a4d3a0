#pragma once

/// \file
/// \brief Numbers sorted into groups, such as bodies into islands, in the room that there is.

#include "06_world/lanes/reserve_space.hpp"

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace cookbook
{

// [groups]
/// Numbers sorted into groups, one group after the other.
class Groups
{
public:
  /// Sorts the numbers below `count` by `group_of(i)`, from 0 to below `groups`, or −1 for none.
  template <class GroupOf>
  void sort(std::size_t groups, std::size_t count, const GroupOf& group_of)
  {
    starts_.assign(groups + 2, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const int group = group_of(i);
      if (group >= 0)
      {
        ++starts_[static_cast<std::size_t>(group) + 2]; // one behind, to be moved on below
      }
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    reserve_space(members_, static_cast<std::size_t>(starts_.back()));
    members_.resize(static_cast<std::size_t>(starts_.back()));
    for (std::size_t i = 0; i < count; ++i)
    {
      const int group = group_of(i);
      if (group >= 0)
      {
        const int place = starts_[static_cast<std::size_t>(group) + 1]++;
        members_[static_cast<std::size_t>(place)] = static_cast<int>(i);
      }
    }
  }

  /// The numbers of a group, the least first.
  std::span<const int> operator[](std::size_t group) const
  {
    return std::span(members_).subspan(
        static_cast<std::size_t>(starts_[group]),
        static_cast<std::size_t>(starts_[group + 1] - starts_[group]));
  }

private:
  std::vector<int> starts_, members_;
};
// [groups]

} // namespace cookbook
