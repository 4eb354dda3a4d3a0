#pragma once

/// \file
/// \brief Flush tiles as one surface, as a module of a world.

#include "06_world/game_world/world_state.hpp"
#include "06_world/seams/join_flush_faces.hpp"

#include <utility>

namespace cookbook
{

// [surfaces_module]
/// Decides contacts with fixed bodies that lie flush by the surface they continue.
class FlushSurfaces : public WorldModule
{
public:
  void collided(WorldState& world) override
  {
    std::swap(seams_.changes, world.changes);
    join_flush_faces(
        seams_, world.scene, world.bodies, world.contacts, contact_margin(world.scene),
        [&](int body) { return is_inactive(world, body); });
  }

  void solved(WorldState& world) override { return_points(seams_, world.contacts); }

private:
  Seams seams_; // room
};
// [surfaces_module]

} // namespace cookbook
