#pragma once

/// \file
/// \brief Scenes under soft steps, one contact at a time in double and many at a time in float.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/plot/charts/chart.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cookbook
{

/// The same scene under both.
struct TwoRuns
{
  WorldRun one_by_one; ///< soft_steps
  WorldRun wide;       ///< wide_steps
};

/// Runs a scene for a time [s] with so many substeps.
inline TwoRuns two_runs(const std::string& scene, int substeps, double duration)
{
  const auto run = [&](const std::string& solver)
  {
    return run_world(
        named_scene(scene),
        {.solver = solver, .substeps = substeps, .duration = duration, .keeps_frames = true});
  };
  return {run("soft_steps"), run("wide_steps")};
}

/// How far apart [m] the two have any body, frame by frame.
inline std::vector<double> farthest_apart(const TwoRuns& runs)
{
  std::vector<double> separation;
  for (std::size_t i = 0; i < runs.wide.frames.size(); ++i)
  {
    const std::vector<BodyState>&a = runs.one_by_one.frames[i].bodies,
          &b = runs.wide.frames[i].bodies;
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
    {
      most = std::max(most, (a[k].position - b[k].position).norm());
    }
    separation.push_back(most);
  }
  return separation;
}

/// The scenes that are compared.
inline const std::vector<std::string> compared_scenes{"tower_1", "tower_5", "pyramid", "incline"};

/// How far apart the two have the bodies of each scene, over time.
inline plot::Chart apart_chart(double duration)
{
  plot::Chart chart(
      "wide_solver", "", {"time [s]", plot::Scale::linear, 0, duration},
      {"farthest body apart [m]", plot::Scale::log});
  chart.describe("How far one contact at a time and many at a time have a body apart, over time.");
  for (const std::string& scene : compared_scenes)
  {
    const std::vector<double> separation = farthest_apart(two_runs(scene, 8, duration));
    std::vector<Eigen::Vector2d> line;
    for (std::size_t i = 6; i < separation.size(); i += 6)
    {
      line.emplace_back(static_cast<double>(i) / 60, std::max(1e-12, separation[i]));
    }
    chart.line(scene, line);
  }
  return chart;
}

} // namespace cookbook
