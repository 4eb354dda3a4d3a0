#pragma once

/// \file
/// \brief How far the top of a tower has gone from where it was in time, solver by solver.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/plot/charts/chart.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// How far [m] the last body of a scene is from where it began, every fifth step of 8 s; not less
/// than a picometre, where a logarithm ends.
inline std::vector<Eigen::Vector2d>
top_over_time(const std::string& scene, const std::string& solver)
{
  const WorldRun run =
      run_world(named_scene(scene), {.solver = solver, .duration = 8, .keeps_frames = true});
  const Vector3<double> start = run.frames.front().bodies.back().position;
  std::vector<Eigen::Vector2d> line;
  for (std::size_t i = 5; i < run.frames.size(); i += 5)
  {
    const double moved = (run.frames[i].bodies.back().position - start).norm();
    line.emplace_back(run.frames[i].time, std::max(moved, 1e-12));
  }
  return line;
}

/// The chart of a tower of ten.
inline plot::Chart top_chart()
{
  plot::Chart chart(
      "direct_solver", "", {"time [s]", plot::Scale::linear},
      {"the top has moved by [m]", plot::Scale::log});
  chart.describe("How far the top of a tower of ten cubes moves in eight seconds.");
  for (const char* const solver : {"cold_impulses", "sequential_impulses", "soft_steps", "direct"})
  {
    chart.line(solver, top_over_time("tower", solver));
  }
  return chart;
}

} // namespace cookbook
