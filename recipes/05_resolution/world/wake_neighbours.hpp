#pragma once

/// \file
/// \brief Waking what a body touches, before it is pushed or removed.

#include "05_resolution/islands/island.hpp"
#include "05_resolution/sleeping/sleeping.hpp"
#include "05_resolution/world/world_state.hpp"

#include <span>
#include <vector>

namespace cookbook
{

/// Wakes bodies, with all that hangs together with them; where none may sleep, none has to be
/// found.
inline void wake_islands_of(WorldState& world, std::span<const int> bodies)
{
  if (world.may_sleep)
  {
    world.islands.find(world.bodies, world.contacts);
    wake(world.sleep, world.islands.numbers(), bodies);
  }
}

/// Wakes whatever touches a body, and all that hangs together with it.
inline void wake_neighbours(WorldState& world, int body)
{
  std::vector<int> touching;
  for (const WorldContact& contact : world.contacts)
  {
    if (contact.a == body || contact.b == body)
    {
      touching.push_back(contact.a + contact.b - body);
    }
  }
  wake_islands_of(world, touching);
}

/// Wakes what sleeps in the bounds of a body, with all that hangs together with it.
inline void wake_touched_by(WorldState& world, const Bounds& bound)
{
  if (!world.may_sleep)
  {
    return;
  }
  std::vector<int> touched;
  for (const Bounds& other : world.bounds)
  {
    if (sleeps(world, other.body) && other.box.intersects(bound.box))
    {
      touched.push_back(other.body);
    }
  }
  wake_islands_of(world, touched);
}

} // namespace cookbook
