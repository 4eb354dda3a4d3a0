#pragma once

/// \file
/// \brief How far towers sink under soft steps, over the number of substeps.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <string>
#include <vector>

namespace cookbook
{

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

/// What happens in a frame of four small steps: time to the right, order from top to bottom.
inline plot::Figure2d frame_figure()
{
  const std::vector<std::string> parts{
      "gravity", "warm start", "springs, friction", "bodies move", "relax"};
  plot::Figure2d figure("soft_steps_frame", "", {{-3, -4.1}, {8.4, 1.1}, 640});
  figure.describe("A frame: contacts are found once, then four small steps of five parts each.");
  figure.label({-0.1, 0.6}, "find contacts", plot::Side::left)
      .box({0.1, 0.6}, 0, {0.1, 0.3}, plot::Ink::b);
  for (std::size_t row = 0; row < parts.size(); ++row)
  {
    const double y = -0.2 - 0.7 * static_cast<double>(row);
    figure.label({-0.1, y}, parts[row], plot::Side::left);
    for (int substep = 0; substep < 4; ++substep)
    {
      const double start = 2.0 * substep + 0.1 + 0.36 * static_cast<double>(row);
      figure.box({start + 0.18, y}, 0, {0.18, 0.3}, plot::Ink::a);
    }
  }
  for (int substep = 0; substep <= 4; ++substep)
  {
    figure.segment(
        {2.0 * substep, -3.5}, {2.0 * substep, 1}, plot::Ink::muted, plot::Stroke::dotted);
    figure.label(
        {2.0 * substep, -3.5},
        substep == 4   ? "h"
        : substep == 0 ? "0"
                       : std::to_string(substep) + " h/4",
        plot::Side::below, plot::Ink::muted);
  }
  return figure;
}

} // namespace cookbook
