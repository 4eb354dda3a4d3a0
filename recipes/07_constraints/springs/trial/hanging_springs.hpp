#pragma once

/// \file
/// \brief Masses on springs side by side, each stepped in its own way, as a drawing that moves.

#include "07_constraints/springs/trial/spring_measure.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// One mass on its spring for each way of spring_ways(), all let go at the same stretch.
struct HangingSprings
{
  static constexpr double most = 2; ///< [m]; one that swings out further has exploded

  double time = 0;                    ///< [s]
  std::vector<PhasePoint<double>> at; ///< of each way
  std::vector<std::vector<Eigen::Vector2d>>
      path;                   ///< time and stretch of each way, the last seconds
  std::vector<bool> exploded; ///< of each way

  /// At rest at a stretch [m].
  explicit HangingSprings(double stretch)
      : at(spring_ways().size(), {stretch, 0}),
        path(at.size(), {{0, stretch}}),
        exploded(at.size(), false)
  {
  }
};

/// Moves all masses on by a step, and forgets what was more than so many seconds ago.
inline void step(HangingSprings& springs, const SpringAsked& asked, double seconds)
{
  springs.time += asked.step;
  const std::vector<SpringWay> ways = spring_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    if (springs.exploded[i])
    {
      continue;
    }
    springs.at[i] = ways[i].step(springs.at[i], asked);
    springs.exploded[i] = !(std::abs(springs.at[i].position) <= HangingSprings::most);
    std::vector<Eigen::Vector2d>& path = springs.path[i];
    if (!springs.exploded[i])
    {
      path.emplace_back(springs.time, springs.at[i].position);
    }
    std::erase_if(path, [&](const auto& one) { return one.x() < springs.time - seconds; });
  }
}

/// A coil spring from the ceiling down to a height, as a zigzag.
inline std::vector<Eigen::Vector2d> zigzag(double x, double top, double bottom)
{
  std::vector<Eigen::Vector2d> points{{x, top}};
  for (int i = 0; i < 12; ++i)
  {
    points.emplace_back(x + (i % 2 == 0 ? 0.22 : -0.22), top + (i + 0.5) * (bottom - top) / 12);
  }
  points.emplace_back(x, bottom);
  return points;
}

/// The masses on their springs under a ceiling; `level` is the stretch at which they are let go.
inline plot::Figure2d
hanging_figure(const HangingSprings& springs, double level, const plot::View& view)
{
  const double ceiling = 2.6;
  plot::Figure2d figure("springs_hang", "", view);
  figure.describe("Masses on springs, side by side: one for each way to step a spring.")
      .half_plane({0, -1}, -ceiling)
      .segment({-1.6, 0}, {5.6, 0}, plot::Ink::muted, plot::Stroke::dotted, 1)
      .segment({-1.6, -level}, {5.6, -level}, plot::Ink::muted, plot::Stroke::dashed, 1);
  for (std::size_t i = 0; i < springs.at.size(); ++i)
  {
    const double x = 1.2 * static_cast<double>(i);
    const plot::Ink ink = plot::series_look(i).ink;
    const std::string name = std::to_string(i + 1);
    if (springs.exploded[i])
    {
      figure.label({x, 0.9}, name + " explodes", plot::Side::above, plot::Ink::overlap);
      continue;
    }
    const double y = -springs.at[i].position;
    figure.polyline(zigzag(x, ceiling, y + 0.3), plot::Ink::ink, plot::Stroke::solid, 1.2)
        .box({x, y}, 0, {0.3, 0.3}, ink)
        .label({x, y - 0.3}, name, plot::Side::below, ink);
  }
  return figure;
}

/// Their stretch over the last seconds.
inline plot::Chart
hanging_chart(const HangingSprings& springs, double seconds, double width, double height)
{
  const double from = std::max(0.0, springs.time - seconds);
  plot::Chart chart(
      "springs_stretch", "", {"time [s]", {}, from, from + seconds},
      {"stretch [m]", {}, -HangingSprings::most, HangingSprings::most});
  chart.describe("The stretch of each spring over time.");
  const std::vector<SpringWay> ways = spring_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    plot::Look look = plot::series_look(i);
    look.marker = plot::Marker::none;
    chart.line(std::to_string(i + 1) + " " + ways[i].name, springs.path[i], look);
  }
  return chart.legend(plot::Legend::below).size(width, height);
}

} // namespace cookbook
