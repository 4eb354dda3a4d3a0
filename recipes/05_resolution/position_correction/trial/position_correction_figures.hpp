#pragma once

/// \file
/// \brief The figures of position correction: height and depth over time, hop over time to get out.

#include "05_resolution/position_correction/trial/position_correction_cases.hpp"
#include "tools/plot/charts/chart.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace cookbook
{

/// The look of the i-th way, the same in each figure.
inline plot::Look way_look(std::size_t i)
{
  const std::vector<plot::Look> looks{
      {plot::Ink::series3, plot::Marker::none, plot::Stroke::dash_dot},
      {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed},
      {plot::Ink::series2, plot::Marker::none, plot::Stroke::dotted},
      {plot::Ink::series5, plot::Marker::none, plot::Stroke::dotted},
      {plot::Ink::series4, plot::Marker::none, plot::Stroke::dashed},
      {plot::Ink::a, plot::Marker::none, plot::Stroke::solid}};
  return looks.at(i);
}

/// The height of the cube's underside over time, by all ways.
inline plot::Chart heights_out_figure()
{
  plot::Chart chart(
      "position_correction", "", {"time [s]", plot::Scale::linear, 0, 2},
      {"height of the underside [m]", plot::Scale::linear, -0.5, 1.5});
  chart.describe("A cube that starts half a metre inside the floor: its height over time.")
      .size(760, 400)
      .legend(plot::Legend::below)
      .reference_y(0, "floor");
  const std::vector<Correction> ways = corrections();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    std::vector<Eigen::Vector2d> points;
    const std::vector<SunkCube> rows = run_out({}, ways[i], 2);
    for (std::size_t row = 0; row < rows.size(); ++row)
    {
      points.emplace_back(double(row) * frame_time, rows[row].bottom);
    }
    chart.line(ways[i].name, points, way_look(i));
  }
  return chart;
}

/// The depth left over time, by the ways without a hop that take more than a frame.
inline plot::Chart depths_figure()
{
  plot::Chart chart(
      "position_correction_depth", "", {"time [s]", plot::Scale::linear, 0, 0.8},
      {"depth [m]", plot::Scale::log, 1e-4, 1});
  chart.describe("How much of half a metre of depth is left over time, by three ways.")
      .size(760, 360)
      .legend(plot::Legend::below);
  const std::vector<Correction> ways = corrections();
  for (const std::size_t i : {3u, 4u, 5u})
  {
    std::vector<Eigen::Vector2d> points;
    const std::vector<SunkCube> rows = run_out({}, ways[i], 0.8);
    for (std::size_t row = 0; row < rows.size() && rows[row].bottom <= -1e-4; ++row)
    {
      points.emplace_back(double(row) * frame_time, -rows[row].bottom);
    }
    chart.line(ways[i].name, points, way_look(i));
  }
  return chart;
}

/// Where a way stands: how long it takes to get out, and how high it hops.
inline Eigen::Vector2d time_and_hop(const std::function<void(SunkCube&)>& advance)
{
  const Recovery found = recovery(run_out({}, {"", advance}, 8));
  return {found.first, found.highest < 1e-6 ? 0 : found.highest};
}

/// Hop over time to get out, a curve for each way over its share, limit or frequency.
inline plot::Chart hops_figure()
{
  std::vector<Eigen::Vector2d> baumgarte, split, soft, hard;
  for (const double limit : {0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0})
  {
    baumgarte.push_back(time_and_hop([=](SunkCube& cube) { push_with_speed(cube, limit); }));
    split.push_back(time_and_hop([=](SunkCube& cube) { push_beside_speed(cube, limit); }));
    soft.push_back(time_and_hop([=](SunkCube& cube) { push_softly(cube, 30, limit); }));
    hard.push_back(time_and_hop([=](SunkCube& cube) { push_softly(cube, 30, limit, false); }));
  }
  plot::Chart chart(
      "position_correction_hops", "", {"time until 1 cm is left [s]", plot::Scale::linear, 0},
      {"hop over the floor [m]", plot::Scale::log});
  chart.describe("How high a cube hops against how long it takes to come out of the floor.")
      .size(760, 420)
      .legend(plot::Legend::below)
      .line("Baumgarte", baumgarte, {plot::Ink::overlap, plot::Marker::cross, plot::Stroke::dashed})
      .line(
          "soft, not relaxed", hard, {plot::Ink::series2, plot::Marker::plus, plot::Stroke::dotted})
      .line(
          "split impulse", split, {plot::Ink::series4, plot::Marker::square, plot::Stroke::dashed})
      .line("soft, relaxed", soft, {plot::Ink::a, plot::Marker::circle, plot::Stroke::solid});
  return chart;
}

} // namespace cookbook
