#pragma once

/// \file
/// \brief Hit events, and restitution, as modules of a world.

#include "06_world/game_world/world_state.hpp"
#include "06_world/impacts/impact.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"

namespace cookbook
{

// [hit_events]
/// Records which bodies hit each other in a step, where and how fast.
class HitEvents : public WorldModule
{
public:
  void added(WorldState& world) override { world.records_impacts = true; }

  void predict(WorldState& world) override
  {
    each_awake_island(
        world, [&](const Island& island)
        { add_impacts(view_of(world), island, world.scene.step, world.impacts); });
  }

  void finished(WorldState& world) override { keep_fastest(world.impacts); }
};
// [hit_events]

// [restitution_module]
/// Lets bodies in contact bounce, all of an island at once.
class Restitution : public WorldModule
{
public:
  void predict(WorldState& world) override
  {
    each_awake_island(
        world,
        [&](const Island& island)
        {
          if (simultaneous_impacts(view_of(world), island, world.scene.step))
          {
            for (const int i : island.bodies)
            {
              set_start_state(world.scene.bodies[index_of(i)], world.bodies[index_of(i)]);
            }
          }
        });
  }
};
// [restitution_module]

} // namespace cookbook
