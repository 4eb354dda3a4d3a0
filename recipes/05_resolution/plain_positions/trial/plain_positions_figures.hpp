#pragma once

/// \file
/// \brief The figure of corrected positions: how far towers sink.

#include "05_resolution/plain_positions/plain_positions.hpp"
#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "05_resolution/small_world/small_world.hpp"
#include "tools/plot/charts/chart.hpp"

#include <vector>

namespace cookbook::small_world
{

/// How far [mm] towers of 1 to 12 cubes sink in a world of a kind within 5 s.
template <class World>
std::vector<Eigen::Vector2d> sinks_of_towers()
{
  std::vector<Eigen::Vector2d> points;
  for (int cubes = 1; cubes <= 12; ++cubes)
  {
    points.emplace_back(cubes, 1000 * largest_sink(tower<World>(cubes), 5));
  }
  return points;
}

/// The sinks of towers under springs and under corrected positions.
inline plot::Chart sinks_figure()
{
  plot::Chart chart(
      "plain_positions", "", {"cubes in the tower", plot::Scale::linear, 0, 13},
      {"the top sinks [mm]", plot::Scale::log, 0.05, 100});
  chart.describe("How far the top of a tower sinks: springs by more than corrected positions.")
      .size(560, 320)
      .line(
          "small world, step 7", sinks_of_towers<small_world::World>(),
          {plot::Ink::overlap, plot::Marker::circle})
      .line(
          "corrected positions", sinks_of_towers<plain_positions::World>(),
          {plot::Ink::a, plot::Marker::square});
  return chart;
}

} // namespace cookbook::small_world
