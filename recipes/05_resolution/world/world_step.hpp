#pragma once

/// \file
/// \brief How a world goes on by a step: everything in this book, in order.

#include "05_resolution/contacts/contact_cache.hpp"
#include "05_resolution/damping/damping.hpp"
#include "05_resolution/sleeping/sleeping.hpp"
#include "05_resolution/sweeps/free_flight.hpp"
#include "05_resolution/sweeps/simultaneous_impacts.hpp"
#include "05_resolution/sweeps/step_sweeps.hpp"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace cookbook
{

// [world_state]
/// All that a world knows; copied, it goes on as the original does.
struct WorldState
{
  Scene scene;                              ///< what the bodies are, and what pulls them
  bool may_sleep = false;                   ///< whether bodies that rest fall asleep
  bool has_balls = false;                   ///< whether any body is a ball
  long steps = 0;                           ///< since the start
  std::vector<RigidBody> bodies;            ///< in the order of the scene
  std::vector<RigidBody> before;            ///< as the last step began
  std::vector<RigidBody> start;             ///< after its impacts
  std::vector<bool> gone;                   ///< who was taken out
  std::vector<bool> falls;                  ///< who fell freely in the last step
  std::vector<SleepState<double>> sleep;    ///< who rests, and for how long
  std::vector<Bounds> bounds;               ///< of all that are there
  BroadPhase near;                          ///< who may touch
  std::vector<WorldContact> contacts;       ///< of the last step
  std::vector<WorldContact> known_contacts; ///< of the one before
  Islands islands;                          ///< who hangs together
  std::vector<IslandPoint> room;            ///< for the points of an island
  std::vector<Course> courses;              ///< of the last step, where it was swept
  std::vector<double> ways;                 ///< [m], how far they led
};

/// Whether a body is left out, since it does not move.
inline bool is_still(const WorldState& world, int body)
{
  return is_fixed(world.bodies[place_of(body)]) || world.sleep[place_of(body)].asleep;
}
// [world_state]

// [world_step]
/// Finds all contacts.
inline void find_contacts(WorldState& world)
{
  const double margin = contact_margin(world.scene);
  for (Bounds& bound : world.bounds)
  {
    const std::size_t i = place_of(bound.body);
    bound.box = bounds_of(world.bodies[i], world.scene.bodies[i].shape, margin / 2);
  }
  std::swap(world.contacts, world.known_contacts);
  next_contacts(
      world.contacts, world.scene, world.bodies, world.known_contacts,
      world.near.pairs(world.bounds), margin, [&](int body) { return is_still(world, body); });
}

/// Has a body fall freely, if no contact has pushed it.
inline void fall_unless_pushed(WorldState& world, std::size_t i, bool touches)
{
  const Scene& scene = world.scene;
  world.falls[i] =
      !touches || !was_pushed(world.bodies[i], world.start[i], scene.gravity, scene.step);
  if (world.falls[i])
  {
    world.bodies[i] = flown(world.start[i], scene.gravity, scene.step);
  }
}

/// Moves an island: bounces, contacts; and what no contact has pushed flies on.
inline void advance(WorldState& world, const Island& island, const IslandSolver& solver)
{
  const IslandView view{world.bodies, world.contacts, world.scene.gravity, world.room};
  const bool touches = !island.contacts.empty();
  if (touches)
  {
    simultaneous_impacts(view, island, world.scene.step);
    for (const int i : island.bodies)
    {
      world.start[place_of(i)] = world.bodies[place_of(i)];
    }
    solver(view, island, world.scene.step);
  }
  for (const int i : island.bodies)
  {
    fall_unless_pushed(world, place_of(i), touches);
  }
}

/// Has bodies bounce off what they would have passed through, and wakes whom they hit.
inline void sweep(WorldState& world)
{
  const std::function<void(int)> wake_up = [&world](int body)
  { wake(world.sleep, world.islands.numbers(), body); };
  StepCourses step{world.scene,       world.contacts, world.falls, world.gone,
                   world.near.tree(), world.courses,  world.ways};
  set_out(step, world.start, world.bodies);
  StepSweeps(step, world.bodies, wake_up).run();
}

/// Has a body's velocity and spin wear off, R32, and watches whether it rests; one whose numbers
/// have overflowed is kept where it was, fixed.
inline void finish(WorldState& world, std::size_t i)
{
  RigidBody& body = world.bodies[i];
  if (!is_finite(body))
  {
    body = world.before[i];
    fix(body);
  }
  if (is_still(world, static_cast<int>(i)))
  {
    return;
  }
  const SceneBody& of = world.scene.bodies[i];
  const double step = world.scene.step;
  if (of.damping > 0 || of.spin_damping > 0)
  {
    body.motion.velocity *= damping_factor(of.damping, step);
    body.motion.angular_velocity *= damping_factor(of.spin_damping, step);
  }
  if (world.may_sleep)
  {
    const double radius = bounds_of(body, of.shape, 0).sizes().norm() / 2;
    world.sleep[i] = watched(
        world.sleep[i], body.motion.velocity, body.motion.angular_velocity, radius, step,
        SleepLimits<double>{});
  }
}

/// Goes on by one step of the scene.
inline void step(WorldState& world, const IslandSolver& solver)
{
  find_contacts(world);
  world.start = world.before = world.bodies;
  world.falls.assign(world.bodies.size(), false);
  world.islands.find(world.bodies, world.contacts);
  if (world.may_sleep)
  {
    settle(world.sleep, world.islands.numbers(), SleepLimits<double>{});
  }
  for (std::size_t i = 0; i < world.islands.size(); ++i)
  {
    const Island island = world.islands[i];
    if (!is_still(world, island.bodies.front()))
    {
      advance(world, island, solver);
    }
  }
  if (world.has_balls || may_have_fast_boxes(world.scene, world.start, world.bodies))
  {
    sweep(world);
  }
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    finish(world, i);
  }
  ++world.steps;
}
// [world_step]

} // namespace cookbook
