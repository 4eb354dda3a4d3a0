#pragma once

/// \file
/// \brief How a world goes on by a step: everything in this book, in order.

#include "06_world/contacts/contact_cache.hpp"
#include "06_world/game_world/world_bodies.hpp"
#include "06_world/game_world/world_state.hpp"
#include "06_world/impacts/toi_solver.hpp"
#include "06_world/islands/free_flight.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"
#include "06_world/seams/join_flush_faces.hpp"
#include "06_world/sweeps/deep_overlaps.hpp"
#include "06_world/sweeps/predicted_contacts.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [world_step]
/// Finds all contacts.
inline void find_contacts(WorldState& world)
{
  const Scene& scene = world.scene;
  const double margin = contact_margin(scene);
  world.prediction.resize(world.bodies.size());
  const PredictedStep step{scene, world.bodies, world.forces, world.prediction};
  for (Bounds& bound : world.bounds)
  {
    world.prediction[index_of(bound.body)] = predict(step, bound.body);
    bound.box = predicted_bounds(step, bound.body, margin);
  }
  update_contacts(
      world.contacts, world.begun, world.seams.changes, scene, world.bodies,
      [&](const auto& call) { world.broad_phase.each_pair(world.bounds, call); },
      [&](int a, int b) { return predicted_margins(step, a, b, margin); },
      [&](int body) { return is_inactive(world, body); });
  join_flush_faces(
      world.seams, scene, world.bodies, world.contacts, margin,
      [&](int body) { return is_inactive(world, body); });
}

/// Solves all islands that are awake: impacts, contacts, free flight.
inline void solve_islands(WorldState& world, const WorldSolver& solver)
{
  const IslandView view{world.bodies, world.contacts, world.scene.gravity, world.solver_scratch,
                        world.forces, &world.falls,   world.constraints,   world.sets};
  world.awake_islands.clear();
  world.impacts.clear();
  const auto for_each_awake = [&](const auto& call)
  {
    for (std::size_t i = 0; i < world.islands.size(); ++i)
    {
      const Island island = world.islands[i];
      if (!is_inactive(world, island.bodies.front()))
      {
        call(island);
      }
    }
  };
  for_each_awake(
      [&](const Island& island)
      {
        if (island.contacts.empty() && island.constraints.empty())
        {
          const std::size_t i = index_of(island.bodies.front());
          world.falls[i] = true;
          integrate_free_flight(world.bodies[i], acceleration_on(world, i), world.scene.step);
          return;
        }
        add_impacts(view, island, world.scene.step, world.impacts);
        world.awake_islands.push_back(island);
        if (simultaneous_impacts(view, island, world.scene.step))
        {
          for (const int i : island.bodies)
          {
            set_start_state(world.scene.bodies[index_of(i)], world.bodies[index_of(i)]);
          }
        }
      });
  solver(view, world.awake_islands, world.scene.step);
}

/// Continuous collision detection: resolves the TOI events of the step, and wakes what is hit.
inline void sweep(WorldState& world)
{
  StepTrajectories step{world.scene,        world.forces,        world.contacts,
                        world.falls,        world.removed,       world.broad_phase.close_pairs(),
                        world.trajectories, world.displacements, world.needs_sweep};
  if (!has_boxes_to_sweep(step, world.prediction, world.bodies) && world.spheres == 0)
  {
    return world.trajectories.shrink_to_fit(); // as long as nothing is swept
  }
  step.tree = &world.broad_phase.tree(world.bounds);
  set_trajectories(step, world.bodies);
  std::vector<int> hit;
  ToiSolver(step, world.bodies, hit, world.impacts).run();
  world.trajectories.clear();
  if (world.may_sleep)
  {
    wake(world.sleep, world.islands.numbers(), hit);
  }
}

/// Damps the velocity and updates the sleep timer; a body whose state overflowed is fixed.
inline void finish_body(WorldState& world, std::size_t i)
{
  RigidBody& body = world.bodies[i];
  if (!is_finite(body))
  {
    body = with_state(body, start_state(world, i));
    fix(body);
  }
  if (is_inactive(world, static_cast<int>(i)))
  {
    return;
  }
  apply_damping(body, world.scene.bodies[i], world.scene.step / 2);
  update_sleep_timer(world, i);
}

/// Goes on by one step of the scene.
inline void step(WorldState& world, const WorldSolver& solver)
{
  const ClearForces forces{world.forces};
  find_contacts(world); // first: it throws where all are in one place; damping only adds to gaps
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (!is_inactive(world, static_cast<int>(i)))
    {
      apply_damping(
          world.bodies[i], world.scene.bodies[i], world.scene.step / 2); // half at the end
    }
    set_start_state(world.scene.bodies[i], world.bodies[i]);
  }
  world.falls.assign(world.bodies.size(), false);
  find_constraints(world);
  world.islands.find(world.bodies, world.contacts, world.constraints);
  update_sleep(world);
  solve_islands(world, solver);
  return_points(world.seams, world.contacts);
  move_driven(world);
  sweep(world);
  keep_fastest(world.impacts);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    finish_body(world, i);
  }
  for (ClonedSet& set : world.sets)
  {
    set->finish(world.bodies, world.scene.step);
  }
  release_slots(world);
  ++world.steps;
}
// [world_step]

} // namespace cookbook
