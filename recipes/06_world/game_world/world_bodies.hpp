#pragma once

/// \file
/// \brief Bodies that are added, removed, teleported or moved by the game, and what wakes of it.

#include "06_world/contacts/bounds.hpp"
#include "06_world/contacts/integrate_body.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/waking.hpp"
#include "06_world/game_world/world_state.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [world_bodies]
/// A body's bounds where it is.
inline Bounds bounds_now(const WorldState& world, std::size_t i)
{
  const auto& shape = world.scene.bodies[i].shape;
  const double margin = contact_margin(world.scene);
  return {bounds_of(world.bodies[i], shape, margin), static_cast<int>(i)};
}

/// Puts something at a place of a list, or behind all.
template <class List, class Item>
void put_at(List& list, std::size_t place, const Item& item)
{
  place < list.size() ? list[place] = item : list.emplace_back(item);
}

/// The slot that the next body is given: a free one, or a new one.
inline std::size_t next_index(const WorldState& world)
{
  return world.free_slots.empty() ? world.bodies.size() : world.free_slots.back();
}

/// Has a body enter the world, and says at which place.
inline std::size_t add_body(WorldState& world, const SceneBody& body)
{
  const std::size_t i = next_index(world);
  const bool had_another = i < world.bodies.size();
  RigidBody made = rigid_body(body);
  made.generation = had_another ? world.bodies[i].generation + 1 : 0;
  put_at(world.scene.bodies, i, body);
  set_start_state(world.scene.bodies[i], made);
  put_at(world.bodies, i, made);
  world.bounds.push_back(bounds_now(world, i));
  put_at(world.removed, i, false);
  if (had_another)
  {
    world.free_slots.pop_back();
  }
  return i;
}

/// Has a body leave it: it stays where it is, and nothing touches it any more. A step later its
/// place is free.
inline void remove_body(WorldState& world, std::size_t i)
{
  wake_around(world, static_cast<int>(i));
  fix(world.bodies[i]);
  world.removed[i] = true;
  for (ClonedSet& set : world.sets)
  {
    set->remove_body(static_cast<int>(i));
  }
  find_constraints(world);
  world.slots_to_free.push_back(i);
  std::erase_if(world.bounds, [&](const Bounds& bound) { return index_of(bound.body) == i; });
  std::erase_if(
      world.scene.ignored,
      [&](const auto& pair) { return index_of(pair.first) == i || index_of(pair.second) == i; });
}

/// Frees the slots of the bodies that were removed before a step.
inline void release_slots(WorldState& world)
{
  world.free_slots.insert(
      world.free_slots.end(), world.slots_to_free.begin(), world.slots_to_free.end());
  world.slots_to_free.clear();
}

/// Puts a body elsewhere, also before the step that was the last.
inline void teleport(
    WorldState& world, std::size_t i, const Vector3<double>& position,
    const Quaternion<double>& orientation)
{
  wake_around(world, static_cast<int>(i));
  RigidBody& body = world.bodies[i];
  body.motion.center = position;
  body.orientation = orientation.normalized();
  update_axes(body);
  world.scene.bodies[i].position = position;
  world.scene.bodies[i].orientation = body.orientation;
  wake_touched_by(world, bounds_now(world, i));
}

/// Moves all kinematic bodies on by a step, with the velocities that the game gave them; a spin
/// stays as it is, whatever the shape.
inline void move_driven(WorldState& world)
{
  const double step = world.scene.step;
  for (RigidBody& body : world.bodies)
  {
    if (is_driven(body))
    {
      integrate_position(body, step);
      body.lagged_orientation = body.orientation;
    }
  }
}
// [world_bodies]

} // namespace cookbook
