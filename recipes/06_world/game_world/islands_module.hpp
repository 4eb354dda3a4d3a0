#pragma once

/// \file
/// \brief Islands, as a module of a world.

#include "06_world/game_world/world_state.hpp"

namespace cookbook
{

// [islands_module]
/// Solves bodies that do not hang together apart from each other; without it all that anything
/// touches is solved, and falls asleep, as one.
class FindIslands : public WorldModule
{
public:
  void added(WorldState& world) override { world.finds_islands = true; }
};
// [islands_module]

} // namespace cookbook
