#pragma once

/// \file
/// \brief What the rows of a world remember from step to step.

#include "06_world/islands/island_view.hpp"
#include "07_constraints/avbd/avbd_settings.hpp"

#include <cstddef>
#include <map>
#include <set>
#include <tuple>

namespace cookbook
{

// [avbd_memory]
/// Which row is which from step to step: a set, a number and no feature, or two bodies and a
/// feature of a contact; then the row of that.
using AvbdKey = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t>;

/// What rows remember.
using AvbdMemories = std::map<AvbdKey, AvbdMemory>;

/// That of the first row of a joint, and of a contact point.
inline AvbdKey key_of(const ConstraintPair& pair)
{
  return {pair.set, static_cast<std::size_t>(pair.number), ~std::size_t(0), 0};
}
inline AvbdKey key_of(const WorldContact& contact, const WorldPoint& point)
{
  return {index_of(contact.a), index_of(contact.b), point.feature, 0};
}

/// That of another row of the same.
inline AvbdKey row_of(AvbdKey key, std::size_t row)
{
  std::get<3>(key) = row;
  return key;
}

/// Once there are twice as many as were kept the last time, drops those of joints and contacts that
/// are gone.
inline void forget_gone(AvbdMemories& memories, std::size_t& kept, IslandView world)
{
  if (memories.size() <= 2 * kept)
  {
    return;
  }
  std::set<AvbdKey> there;
  for (const ConstraintPair& pair : world.constraints)
  {
    there.insert(key_of(pair));
  }
  for (const WorldContact& contact : world.contacts)
  {
    for (const WorldPoint& point : contact.points)
    {
      there.insert(key_of(contact, point));
    }
  }
  std::erase_if(memories, [&](const auto& one) { return !there.contains(row_of(one.first, 0)); });
  kept = memories.size() + 64;
}
// [avbd_memory]

} // namespace cookbook
