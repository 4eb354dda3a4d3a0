#pragma once

/// \file
/// \brief What hangs together by constraints, and what wakes together.

#include "06_world/contacts/bounds.hpp"
#include "06_world/game_world/invalid_scene.hpp"
#include "06_world/game_world/world_state.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

// [waking]
/// Asks all sets for their pairs: std::out_of_range where one is of a body that is not there,
/// InvalidScene where one joins a body with itself. Those that do not touch are ignored from now
/// on, as by GameWorld::ignore().
inline void find_constraints(WorldState& world)
{
  world.constraints.clear();
  const auto check = [&](int body)
  {
    const std::size_t i = static_cast<std::size_t>(body);
    if (body < 0 || i >= world.bodies.size() || world.removed[i])
    {
      throw invalid_id(world, static_cast<BodyId>(body));
    }
  };
  for (std::size_t set = 0; set < world.sets.size(); ++set)
  {
    world.sets[set]->each_pair(
        [&](ConstraintPair pair)
        {
          check(pair.a);
          check(pair.b);
          if (pair.a == pair.b)
          {
            throw InvalidScene(
                std::string(world.sets[set]->name()) + ": number " + std::to_string(pair.number) +
                " joins body " + std::to_string(pair.a) + " with itself");
          }
          pair.set = set;
          world.constraints.push_back(pair);
          const std::pair<int, int> both = std::minmax(pair.a, pair.b);
          if (!pair.collides && !ignores(world.scene, both))
          {
            auto& ignored = world.scene.ignored;
            ignored.insert(std::upper_bound(ignored.begin(), ignored.end(), both), both);
          }
        });
  }
}

/// Tells all modules that the game has changed bodies: they wake, with all that hangs together with
/// them.
inline void wake_islands_of(WorldState& world, std::span<const int> bodies)
{
  for (const Cloned<WorldModule>& module : world.modules)
  {
    module->changed(world, bodies);
  }
}

/// Wakes a body, whatever touches it, and all that hangs together with them.
inline void wake_around(WorldState& world, int body)
{
  std::vector<int> awake_islands{body};
  for (const WorldContact& contact : world.contacts)
  {
    if (contact.a == body || contact.b == body)
    {
      awake_islands.push_back(contact.a + contact.b - body);
    }
  }
  for (const ConstraintPair& pair : world.constraints)
  {
    if (pair.a == body || pair.b == body)
    {
      awake_islands.push_back(pair.a + pair.b - body);
    }
  }
  wake_islands_of(world, awake_islands);
}

/// Wakes what sleeps in the bounds of a body, with all that hangs together with it.
inline void wake_touched_by(WorldState& world, const Bounds& bound)
{
  if (world.asleep.empty())
  {
    return;
  }
  std::vector<int> touched;
  for (const Bounds& other : world.bounds)
  {
    if (is_asleep(world, other.body) && other.box.intersects(bound.box))
    {
      touched.push_back(other.body);
    }
  }
  wake_islands_of(world, touched);
}

/// Wakes the bodies of a set's constraints.
inline void wake_joined(WorldState& world, std::size_t set)
{
  std::vector<int> joined;
  for (const ConstraintPair& pair : world.constraints)
  {
    if (pair.set == set)
    {
      joined.insert(joined.end(), {pair.a, pair.b});
    }
  }
  wake_islands_of(world, joined);
}
// [waking]

} // namespace cookbook
