#pragma once

/// \file
/// \brief Which bodies of a world have begun to press on each other, and which have ceased to.

#include "06_world/contacts/world_contact.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [contact_events]
/// Compares the contacts of a world from one look to the next; pairs are those of ids.
///
/// What touches and parts between two looks is not seen, and neither is what a sweep has bounced
/// off within a step. Who is only moved out of an overlap does not press.
class ContactEvents
{
public:
  using Pair = std::pair<BodyId, BodyId>; ///< two bodies

  /// Looks at the contacts of a world's last step, and whose they are.
  void update(std::span<const WorldContact> contacts, std::span<const RigidBody> bodies)
  {
    std::swap(now_, before_);
    now_.clear();
    for (const WorldContact& contact : contacts)
    {
      if (is_touching(contact))
      {
        now_.emplace_back(id_at(bodies, index_of(contact.a)), id_at(bodies, index_of(contact.b)));
      }
    }
    std::sort(now_.begin(), now_.end());
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

  const std::vector<Pair>& active() const { return now_; }  ///< in order
  const std::vector<Pair>& begun() const { return begun_; } ///< since the last look
  const std::vector<Pair>& ended() const { return ended_; } ///< since the last look

private:
  std::vector<Pair> now_, before_, begun_, ended_;
};
// [contact_events]

} // namespace cookbook
