#pragma once

/// \file
/// \brief Which bodies of a world have begun to press on each other, and which have ceased to.

#include "05_resolution/contacts/world_contact.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [contact_watch]
/// Compares the contacts of a world from one look to the next; pairs have the smaller number first.
///
/// What touches and parts between two looks is not seen, and neither is what a sweep has bounced
/// off within a step.
class ContactWatch
{
public:
  /// Looks at the contacts of the last step, ordered by their bodies as a world has them.
  void look(std::span<const WorldContact> contacts)
  {
    std::swap(now_, before_);
    now_.clear();
    for (const WorldContact& contact : contacts)
    {
      if (presses(contact))
      {
        now_.push_back(pair_of(contact));
      }
    }
    begun_.clear();
    ended_.clear();
    const auto only = [](const auto& in, const auto& not_in, auto& found)
    {
      std::set_difference(
          in.begin(), in.end(), not_in.begin(), not_in.end(), std::back_inserter(found));
    };
    only(now_, before_, begun_);
    only(before_, now_, ended_);
  }

  const std::vector<std::pair<int, int>>& pressing() const { return now_; } ///< in order
  const std::vector<std::pair<int, int>>& begun() const { return begun_; }  ///< since the last look
  const std::vector<std::pair<int, int>>& ended() const { return ended_; }  ///< since the last look

private:
  std::vector<std::pair<int, int>> now_, before_, begun_, ended_;
};
// [contact_watch]

} // namespace cookbook
