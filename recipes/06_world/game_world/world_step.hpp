#pragma once

/// \file
/// \brief How a world goes on by a step: contacts, islands, the solver, and modules around them.

#include "06_world/contacts/contact_cache.hpp"
#include "06_world/game_world/world_bodies.hpp"
#include "06_world/game_world/world_state.hpp"
#include "06_world/islands/free_flight.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace cookbook
{

// [world_step]
/// Finds all contacts: of the pairs whose bounds overlap, those within their margins.
inline void find_contacts(WorldState& world)
{
  const auto looks = [](const Cloned<WorldModule>& module) { return module->looks_ahead(); };
  const auto found = std::find_if(world.modules.begin(), world.modules.end(), looks);
  WorldModule* const ahead = found == world.modules.end() ? nullptr : &**found;
  for (Bounds& bound : world.bounds)
  {
    bound.box = ahead != nullptr ? ahead->bounds(world, bound.body)
                                 : bounds_now(world, index_of(bound.body)).box;
  }
  const double margin = contact_margin(world.scene);
  update_contacts(
      world.contacts, world.begun, world.changes, world.scene, world.bodies,
      [&](const auto& call) { world.pair_finder->each_pair(world.bounds, std::ref(call)); },
      [&](int a, int b) {
        return ahead != nullptr ? ahead->margins(world, a, b) : ContactMargins{margin, margin};
      },
      [&](int body) { return is_inactive(world, body); });
}

/// Damps a body that is awake for half a step.
inline void damp(WorldState& world, std::size_t i)
{
  if (!is_inactive(world, static_cast<int>(i)))
  {
    apply_damping(world.bodies[i], world.scene.bodies[i], world.scene.step / 2);
  }
}

/// Moves all bodies that are awake: those of islands by the solver, those alone in free flight.
inline void move_bodies(WorldState& world, const WorldSolver& solver)
{
  world.awake_islands.clear();
  each_awake_island(world, [&](const Island& island) { world.awake_islands.push_back(island); });
  solver(view_of(world), world.awake_islands, world.scene.step);
  for (std::size_t k = 0; k < world.islands.size(); ++k)
  {
    const Island island = world.islands[k];
    const int body = island.bodies.front();
    if (is_alone(island) && !is_inactive(world, body))
    {
      const std::size_t i = index_of(body);
      world.falls[i] = true;
      integrate_free_flight(world.bodies[i], acceleration_on(world, i), world.scene.step);
    }
  }
  move_driven(world);
}

/// Damps the velocity; a body whose state overflowed is fixed.
inline void finish_body(WorldState& world, std::size_t i)
{
  RigidBody& body = world.bodies[i];
  if (!is_finite(body))
  {
    body = with_state(body, start_state(world, i));
    fix(body);
  }
  damp(world, i);
}

/// Goes on by one step of the scene.
inline void step(WorldState& world, const WorldSolver& solver)
{
  const ClearForces forces{world.forces};
  const auto call_modules = [&](auto function)
  {
    for (const Cloned<WorldModule>& module : world.modules)
    {
      ((*module).*function)(world);
    }
  };
  find_constraints(world); // first: they throw where bodies are not there, or all in one place
  find_contacts(world);
  call_modules(&WorldModule::collided);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    damp(world, i);
    set_start_state(world.scene.bodies[i], world.bodies[i]);
  }
  find_islands(world);
  world.falls.assign(world.bodies.size(), false);
  world.impacts.clear();
  call_modules(&WorldModule::predict);
  move_bodies(world, solver);
  call_modules(&WorldModule::solved);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    finish_body(world, i);
  }
  call_modules(&WorldModule::finished);
  for (ClonedSet& set : world.sets)
  {
    set->finish(world.bodies, world.scene.step);
  }
  release_slots(world);
  ++world.steps;
}
// [world_step]

} // namespace cookbook
