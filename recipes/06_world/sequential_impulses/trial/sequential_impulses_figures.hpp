#pragma once

/// \file
/// \brief The figure of sequential impulses: how far from an answer they are after some passes.

#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "tools/plot/charts/chart.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The residuals of three towers against the number of passes.
inline plot::Chart residual_figure()
{
  plot::Chart chart(
      "sequential_impulses", "", {"passes", plot::Scale::log, 1, 1000},
      {"residual [m/s]", plot::Scale::log, 1e-5, 1});
  chart.describe("The residual of three towers of cubes against the number of passes.")
      .size(560, 340)
      .reference_x(8, "8 passes");
  for (const int cubes : {3, 5, 10})
  {
    std::vector<Eigen::Vector2d> line;
    const std::vector<double> all = residuals(cubes, 1000);
    for (std::size_t pass = 1; pass < all.size() && all[pass] > 1e-5; ++pass)
    {
      line.emplace_back(pass, all[pass]);
    }
    chart.line(std::to_string(cubes) + " cubes", line);
  }
  return chart;
}

} // namespace cookbook
