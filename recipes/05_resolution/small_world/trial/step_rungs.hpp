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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook::small_world
{

/// How many of five shots, at 10 to 1000 m/s, come back from a wall.
template <class World>
Verdict shots_back()
{
  return come_back(static_cast<std::size_t>(std::count_if(
      shot_speeds.begin(), shot_speeds.end(),
      [](double speed) { return comes_back(shot_at_wall<World>(speed)); })));
}

/// How many contact points a world of 400 cubes solves in its 120th frame.
template <class World>
Verdict points_solved()
{
  World world = floor_of_cubes<World>(20);
  run(world, 2);
  return {world.contacts.empty(), std::to_string(world.contacts.size()) + " points"};
}

/// How many of all pairs are compared: no more than a tenth is right.
inline Verdict compared(std::size_t pairs, std::size_t all)
{
  return {10 * pairs <= all, std::to_string(pairs) + " pairs"};
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
  const step_4::World cubes = floor_of_cubes<step_4::World>(20);
  const std::size_t count = cubes.bodies.size(), all = count * (count - 1) / 2;
  return {
      {"1", "impulses, friction", "tower of 5, 20 s", Verdict{false, ""},
       sinks(largest_sink(tower<step_1::World>(5), 20)), "stands"},
      {"2", "warm starting", "pyramid of 55, 20 s",
       sinks(largest_sink(pyramid<step_1::World>(10), 20)),
       sinks(largest_sink(pyramid<step_2::World>(10), 20)), "stands"},
      {"3", "soft steps", "tower of 10, 40 s", sinks(largest_sink(tower<step_2::World>(10), 40)),
       sinks(largest_sink(tower<step_3::World>(10), 40)), "stands"},
      {"4", "broad phase", "400 cubes", compared(all, all),
       compared(pairs_compared(cubes.bodies), all), "400 touch"},
      {"5", "restitution", "dropped 1 m, e = 0.5", bounce<step_4::World>(), bounce<step_5::World>(),
       "0.25 m"},
      {"6", "sleeping", "400 cubes, after 2 s", points_solved<step_5::World>(),
       points_solved<step_6::World>(), "0 points"},
      {"7", "swept spheres", "wall, 10 to 1000 m/s", shots_back<step_6::World>(),
       shots_back<step_7::World>(), "5 of 5 come back"}};
}

} // namespace cookbook::small_world
