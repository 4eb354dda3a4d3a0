#pragma once

/// \file
/// \brief How a world goes on by a step: everything in this book, in order.

#include "06_world/contacts/contact_cache.hpp"
#include "06_world/game_world/world_bodies.hpp"
#include "06_world/game_world/world_state.hpp"
#include "06_world/impacts/step_sweeps.hpp"
#include "06_world/islands/free_flight.hpp"
#include "06_world/islands/simultaneous_impacts.hpp"
#include "06_world/sweeps/foreseen.hpp"
#include "06_world/sweeps/too_deep.hpp"

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
  world.ahead.resize(world.bodies.size());
  const StepAhead step{scene, world.bodies, world.forces, world.ahead};
  for (Bounds& bound : world.bounds)
  {
    world.ahead[place_of(bound.body)] = ahead_of(step, bound.body);
    bound.box = foreseen_bounds(step, bound.body, margin);
  }
  update_contacts(
      world.contacts, world.begun, scene, world.bodies,
      [&](const auto& call) { world.broad_phase.each_pair(world.bounds, call); },
      [&](int a, int b) { return foreseen_reach(step, a, b, margin); },
      [&](int body) { return is_still(world, body); });
}

/// Has the bodies of an island fall freely that no contact has pushed or moved out of an overlap.
inline void fall_unless_pushed(WorldState& world, const Island& island)
{
  const double step = world.scene.step;
  if (island.contacts.empty())
  {
    const std::size_t i = place_of(island.bodies.front());
    world.falls[i] = true;
    return fly(world.bodies[i], pull_on(world, i), step);
  }
  for (const int body : island.bodies)
  {
    const std::size_t i = place_of(body);
    world.falls[i] = !was_pushed(world.bodies[i], start_of(world, i), pull_on(world, i), step);
  }
  for (const int number : island.contacts)
  {
    const WorldContact& contact = world.contacts[place_of(number)];
    const std::size_t a = place_of(contact.a), b = place_of(contact.b);
    const auto pushed = [&](std::size_t i)
    { return !world.falls[i] && !is_fixed(world.bodies[i]); };
    const auto step_of = [&](std::size_t i)
    { return unpushed(world.bodies[i], start_of(world, i), pull_on(world, i).acceleration, step); };
    if (!pushed(a) && !pushed(b) && were_parted(step_of(a), step_of(b)))
    {
      world.parted[a] = world.parted[b] = true;
    }
  }
  for (const int body : island.bodies)
  {
    const std::size_t i = place_of(body);
    world.falls[i] = world.falls[i] && !world.parted[i];
    if (world.falls[i])
    {
      world.bodies[i] = as_it_was(world.bodies[i], start_of(world, i));
      fly(world.bodies[i], pull_on(world, i), step);
    }
    else if (!world.parted[i] && island.bodies.size() == 1)
    {
      slide(world.bodies[i], start_of(world, i), pull_on(world, i).acceleration, step);
    }
  }
}

/// Moves all islands that are awake: bounces, contacts; and what no contact has pushed flies on.
inline void advance(WorldState& world, const WorldSolver& solver)
{
  const IslandView view{
      world.bodies, world.contacts, world.scene.gravity, world.room, world.forces};
  world.touching.clear();
  world.impacts.clear();
  const auto for_each_awake = [&](const auto& call)
  {
    for (std::size_t i = 0; i < world.islands.size(); ++i)
    {
      const Island island = world.islands[i];
      if (!is_still(world, island.bodies.front()))
      {
        call(island);
      }
    }
  };
  for_each_awake(
      [&](const Island& island)
      {
        if (!island.contacts.empty())
        {
          add_impacts(view, island, world.scene.step, world.impacts);
          world.touching.push_back(island);
          if (simultaneous_impacts(view, island, world.scene.step))
          {
            for (const int i : island.bodies)
            {
              set_start(world.scene.bodies[place_of(i)], world.bodies[place_of(i)]);
            }
          }
        }
      });
  solver(view, world.touching, world.scene.step);
  for_each_awake([&](const Island& island) { fall_unless_pushed(world, island); });
}

/// Has bodies bounce off what they would have passed through, or been too deep in, and wakes whom
/// they hit.
inline void sweep(WorldState& world)
{
  StepCourses step{world.scene,   world.forces, world.contacts,
                   world.falls,   world.gone,   world.broad_phase.close_pairs(),
                   world.courses, world.ways,   world.too_deep};
  if (!has_boxes_to_sweep(step, world.ahead, world.bodies) && world.balls == 0)
  {
    return world.courses.shrink_to_fit(); // as long as nothing is swept
  }
  step.tree = &world.broad_phase.tree(world.bounds);
  set_out(step, world.bodies);
  std::vector<int> hit;
  StepSweeps(step, world.bodies, hit, world.impacts).run();
  world.courses.clear();
  if (world.may_sleep)
  {
    wake(world.sleep, world.islands.numbers(), hit);
  }
}

/// Has a body's motion wear off, and watches whether it rests; one whose numbers have overflowed is
/// kept where it was, fixed.
inline void finish(WorldState& world, std::size_t i)
{
  RigidBody& body = world.bodies[i];
  if (!is_finite(body))
  {
    body = as_it_was(body, start_of(world, i));
    fix(body);
  }
  if (is_still(world, static_cast<int>(i)))
  {
    return;
  }
  wear_off(body, world.scene.bodies[i], world.scene.step / 2);
  watch_rest(world, i);
}

COOKBOOK_WORLD_INLINE void step(WorldState& world, const WorldSolver& solver)
{
  const ForcesOfStep forces{world.forces};
  find_contacts(world); // first: it throws where all are in one place; damping only adds to gaps
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    if (!is_still(world, static_cast<int>(i)))
    {
      wear_off(world.bodies[i], world.scene.bodies[i], world.scene.step / 2); // half at the end
    }
    set_start(world.scene.bodies[i], world.bodies[i]);
  }
  world.falls.assign(world.bodies.size(), false);
  world.parted.assign(world.bodies.size(), false);
  world.islands.find(world.bodies, world.contacts);
  if (world.may_sleep)
  {
    settle(world.sleep, world.islands.numbers(), SleepLimits<double>{});
  }
  advance(world, solver);
  sweep(world);
  keep_fastest(world.impacts);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    finish(world, i);
  }
  free_places(world);
  ++world.steps;
}
// [world_step]

} // namespace cookbook
