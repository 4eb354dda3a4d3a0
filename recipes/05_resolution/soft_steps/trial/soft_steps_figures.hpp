#pragma once

/// \file
/// \brief How far towers sink under soft steps, over the number of substeps.

#include "05_resolution/scenes/trial/world_scenes.hpp"
#include "05_resolution/world/trial/world_runs.hpp"
#include "common/plot/charts/chart.hpp"

#include <string>
#include <vector>

namespace cookbook
{

// [sinks]
/// How far a tower has come down, and gone aside, after a time.
struct Sink
{
  int substeps;
  double down;  ///< [m]
  double aside; ///< [m]
};

/// The sinks of a scene under soft steps after 5 s, for 2, 4, … 32 substeps.
inline std::vector<Sink> sinks(const std::string& scene)
{
  std::vector<Sink> all;
  for (int substeps = 2; substeps <= 32; substeps *= 2)
  {
    RunSettings settings{.solver = "soft_steps", .substeps = substeps, .duration = 5};
    const WorldRun run = run_world(named_scene(scene), settings);
    all.push_back({substeps, run.sink, run.drift});
  }
  return all;
}
// [sinks]

/// The towers whose sinks are printed and drawn.
inline const std::vector<std::string> sinking_scenes{
    "tower_1", "tower_5", "tower_10", "heavy_on_light_10"};

/// The chart of sinks, given scene by scene as `sinking_scenes` has them.
inline plot::Chart sink_chart(const std::vector<std::vector<Sink>>& all)
{
  plot::Chart chart(
      "soft_steps", "", {"substeps in a frame", plot::Scale::log}, {"sink [m]", plot::Scale::log});
  chart.describe(
      "How far four scenes sink under soft steps: four times less for twice the substeps.");
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::vector<Eigen::Vector2d> line;
    for (const Sink& one : all[i])
    {
      line.emplace_back(one.substeps, one.down);
    }
    chart.line(sinking_scenes[i], line);
  }
  return chart;
}

} // namespace cookbook
