#pragma once

/// \file
/// \brief Each step of the small world on the scene that it holds and the step before fails.

#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_4.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "05_resolution/small_world/trial/rung.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook::small_world
{

/// What a stack of cubes does in a time [s]: its sink in mm, or that it falls.
template <class World>
Verdict sink_of(const World& world, double time)
{
  const double sink = largest_sink(world, time);
  return {stands(sink), stands(sink) ? "sinks " + rounded(1000 * sink) + " mm" : "falls"};
}

/// How many of five shots, at 10 to 1000 m/s, come back from a wall.
template <class World>
Verdict shots_back()
{
  int count = 0;
  for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    count += comes_back(shot_at_wall<World>(speed)) ? 1 : 0;
  }
  return {count == 5, std::to_string(count) + " of 5 come back"};
}

/// How many contact points a world of 400 cubes solves in its 120th frame.
template <class World>
Verdict points_solved()
{
  World world = floor_of_cubes<World>(20);
  run(world, 2);
  return {world.contacts.empty(), std::to_string(world.contacts.size()) + " points"};
}

/// How many pairs of 400 cubes and the ground are compared: no more than a tenth of all is right.
inline Verdict compared(std::size_t pairs)
{
  const std::size_t count = floor_of_cubes<step_4::World>(20).bodies.size();
  return {20 * pairs <= count * (count - 1), std::to_string(pairs) + " pairs"};
}

/// All pairs of a world of 400 cubes: every body against every other.
inline std::size_t all_pairs()
{
  const std::size_t count = floor_of_cubes<step_4::World>(20).bodies.size();
  return count * (count - 1) / 2;
}

/// How high a sphere comes back that is dropped from 1 m with a restitution of 0.5; within 1 % is
/// right.
template <class World>
Verdict bounce()
{
  const double height = height_of_bounce(dropped_sphere<World>(1, 0.5), 1.2);
  return {std::abs(height - 0.25) < 0.0025, number(std::round(1e3 * height) * 1e-3) + " m"};
}

/// The seven steps.
inline std::vector<Rung> step_rungs()
{
  const std::size_t swept = pairs_compared(floor_of_cubes<step_4::World>(20).bodies);
  return {
      {"1", "impulses, friction", "tower of 5, 20 s", Verdict{false, ""},
       sink_of(tower<step_1::World>(5), 20), "stands"},
      {"2", "warm starting", "pyramid of 55, 20 s", sink_of(pyramid<step_1::World>(10), 20),
       sink_of(pyramid<step_2::World>(10), 20), "stands"},
      {"3", "soft steps", "tower of 10, 40 s", sink_of(tower<step_2::World>(10), 40),
       sink_of(tower<step_3::World>(10), 40), "stands"},
      {"4", "broad phase", "400 cubes", compared(all_pairs()), compared(swept), "400 touch"},
      {"5", "restitution", "dropped 1 m, e = 0.5", bounce<step_4::World>(), bounce<step_5::World>(),
       "0.25 m"},
      {"6", "sleeping", "400 cubes, after 2 s", points_solved<step_5::World>(),
       points_solved<step_6::World>(), "0 points"},
      {"7", "swept spheres", "wall, 10 to 1000 m/s", shots_back<step_6::World>(),
       shots_back<step_7::World>(), "5 of 5 come back"}};
}

} // namespace cookbook::small_world
