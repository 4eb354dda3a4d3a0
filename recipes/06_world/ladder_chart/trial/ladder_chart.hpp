#pragma once

/// \file
/// \brief What each rung of the ladder costs and how wrong it is: time, bytes, moves, overlaps.

#include "05_resolution/plain_direct/plain_direct.hpp"
#include "05_resolution/plain_positions/plain_positions.hpp"
#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_4.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "06_world/game_world/trial/counted_allocations.hpp"
#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/ladder/trial/ladder.hpp"
#include "06_world/ladder/trial/ladder_scenes.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace cookbook
{

/// A world with a scene in it, as the chart asks of any.
struct LadderWorld
{
  std::function<void()> step;
  std::function<double()> moved;   ///< [m], the farthest that a body is from where it began
  std::function<double()> overlap; ///< [m], the deepest now
};

/// A rung of the chart; nothing falls asleep in it.
struct LadderMethod
{
  std::string name;
  std::function<LadderWorld(const Scene&)> build;
  bool of_steps = false;    ///< whether it belongs to the line of the small world
  double most_bodies = 1e3; ///< in scenes of more it takes too long
};

/// A scene in a step of the small world.
template <class World>
LadderWorld small_ladder_world(const Scene& scene)
{
  const auto world = std::make_shared<World>(small_of<World>(scene));
  const auto moved = [world, start = world->bodies]
  { return small_world::farthest_move(start, world->bodies); };
  const auto step_once = [world, time = scene.step]
  {
    keep_awake(*world);
    step(*world, time);
  };
  return {step_once, moved, [world] { return deepest_now(*world); }};
}

/// A scene in GameWorld under a solver by name.
inline LadderWorld game_ladder_world(const Scene& scene, const std::string& solver)
{
  const auto world = std::make_shared<SteppedWorld>(scene, solver, 0);
  const auto moved = [world, scene]
  {
    const Frame frame = world->frame();
    double most = 0;
    for (std::size_t i = 0; i < frame.bodies.size(); ++i)
    {
      most = std::max(most, (frame.bodies[i].position - scene.bodies[i].position).norm());
    }
    return most;
  };
  return {[world] { world->step(); }, moved, [world] { return world->deepest_overlap(); }};
}

// [ladder_methods]
/// The seven steps, the plain alternatives to them, and GameWorld under three solvers.
inline std::vector<LadderMethod> ladder_methods()
{
  const auto game = [](const std::string& solver)
  { return [solver](const Scene& scene) { return game_ladder_world(scene, solver); }; };
  return {
      {"step 1", small_ladder_world<small_world::step_1::World>, true},
      {"step 2", small_ladder_world<small_world::step_2::World>, true},
      {"step 3", small_ladder_world<small_world::step_3::World>, true},
      {"step 4", small_ladder_world<small_world::step_4::World>, true},
      {"step 5", small_ladder_world<small_world::step_5::World>, true},
      {"step 6", small_ladder_world<small_world::step_6::World>, true},
      {"step 7", small_ladder_world<small_world::step_7::World>, true},
      {"plain positions", small_ladder_world<small_world::plain_positions::World>},
      {"plain direct", small_ladder_world<small_world::plain_direct::World>, false, 10},
      {"GameWorld, soft steps", game("soft_steps")},
      {"GameWorld, wide steps", game("wide_steps")},
      {"GameWorld, direct", game("direct")}};
}
// [ladder_methods]

/// A scene of the chart; what stands is to stay where it is, what falls is not to overlap.
struct LadderScene
{
  std::string what;
  Scene scene;
  double time; ///< [s]
  bool stands;
};

/// Three scenes that stand, and one that falls.
inline std::vector<LadderScene> ladder_scenes()
{
  return {
      {"tower of 10, 40 s", scenes::tower(10), 40, true},
      {"pyramid of 55, 10 s", scenes::pyramid(10), 10, true},
      {"floor of 400, 1 s", scenes::floor_of_cubes(400), 1, true},
      {"heap of 60, 3 s", scenes::pile(60), 3, false}};
}

/// Whether a method is run in a scene.
inline bool takes_part(const LadderMethod& method, const LadderScene& one)
{
  return movable_bodies(one.scene) <= method.most_bodies;
}

/// How wrong a method is in a scene, and what it holds in memory.
struct LadderEnd
{
  double error; ///< [m], the farthest that a body has moved, or the deepest overlap at any time
  double bytes; ///< a body, at the end
};

/// Runs a scene once.
inline LadderEnd ladder_end(const LadderMethod& method, const LadderScene& one)
{
  const long before = held_bytes();
  const LadderWorld world = method.build(one.scene);
  double deepest = 0;
  for (std::size_t i = 0; i < steps_of(one.scene, one.time); ++i)
  {
    world.step();
    deepest = one.stands ? 0 : std::max(deepest, world.overlap());
  }
  const double bytes = static_cast<double>(held_bytes() - before);
  return {one.stands ? world.moved() : deepest, bytes / movable_bodies(one.scene)};
}

// [ladder_seconds]
/// The time [s] a body and step of each method in a scene, from two measurements in a row; NaN
/// where one of them is more than half as long again as the other: the machine was busy.
inline std::vector<double>
ladder_seconds(const std::vector<LadderMethod>& methods, const LadderScene& one, int repetitions)
{
  std::vector<TimedWorld> worlds;
  for (const LadderMethod& method : methods)
  {
    worlds.push_back({method.name, [&] { return method.build(one.scene).step; }});
  }
  const int steps = static_cast<int>(steps_of(one.scene, one.time));
  std::vector<double> seconds = step_seconds(worlds, steps, repetitions);
  const std::vector<double> again = step_seconds(worlds, steps, repetitions);
  for (std::size_t i = 0; i < seconds.size(); ++i)
  {
    const auto [least, most] = std::minmax(seconds[i], again[i]);
    const bool busy = most > 1.5 * least;
    seconds[i] =
        busy ? std::numeric_limits<double>::quiet_NaN() : least / movable_bodies(one.scene);
  }
  return seconds;
}
// [ladder_seconds]

} // namespace cookbook
