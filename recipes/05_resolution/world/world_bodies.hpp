#pragma once

/// \file
/// \brief Bodies that come, go and are put elsewhere, and who wakes of it.

#include "05_resolution/contacts/bounds.hpp"
#include "05_resolution/islands/island.hpp"
#include "05_resolution/sleeping/sleeping.hpp"
#include "05_resolution/world/world_state.hpp"

#include <algorithm>
#include <cstddef>
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

/// Wakes a body, whatever touches it, and all that hangs together with them.
inline void wake_around(WorldState& world, int body)
{
  if (!world.may_sleep)
  {
    return;
  }
  std::vector<int> touching{body};
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

// [world_bodies]
/// A body's bounds where it is.
inline Bounds bounds_now(const WorldState& world, std::size_t i)
{
  const auto& shape = world.scene.bodies[i].shape;
  const double margin = contact_margin(world.scene);
  return {bounds_of(world.bodies[i], shape, margin), static_cast<int>(i)};
}

/// Has the scene's next body enter the world.
inline void enter(WorldState& world)
{
  const std::size_t i = world.bodies.size();
  world.bodies.push_back(rigid_body(world.scene.bodies[i]));
  world.bounds.push_back(bounds_now(world, i));
  world.gone.push_back(false);
  world.sleep.resize(world.may_sleep ? world.bodies.size() : 0);
  world.has_balls = world.has_balls || world.bodies[i].round;
}

/// Has a body leave it: it stays where it is, and nothing touches it any more.
inline void leave(WorldState& world, std::size_t i)
{
  wake_around(world, static_cast<int>(i));
  fix(world.bodies[i]);
  world.gone[i] = true;
  std::erase_if(world.bounds, [&](const Bounds& bound) { return place_of(bound.body) == i; });
}

/// Puts a body elsewhere, also before the step that was the last.
inline void put_elsewhere(
    WorldState& world, std::size_t i, const Vector3<double>& position,
    const Quaternion<double>& orientation)
{
  wake_around(world, static_cast<int>(i));
  RigidBody& body = world.bodies[i];
  body.motion.center = position;
  body.orientation = orientation.normalized();
  update_axes(body);
  if (i < world.start.size())
  {
    world.start[i].motion.center = position;
    world.start[i].orientation = body.orientation;
  }
  wake_touched_by(world, bounds_now(world, i));
}
// [world_bodies]

} // namespace cookbook
