#pragma once

/// \file
/// \brief The figures of corrected positions: small steps against passes, for the same work.

#include "06_world/position_based/trial/position_based_scenes.hpp"
#include "06_world/position_based/trial/solvers_cases.hpp"
#include "tools/plot/charts/chart.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// How far [mm] the top of a column rests below its place, against the passes in a frame, given to
/// small steps or not.
inline std::vector<Eigen::Vector2d> sink_by_budget(const std::vector<double>& masses, bool steps)
{
  std::vector<Eigen::Vector2d> points;
  for (int count = 1; count <= 128; count *= 2)
  {
    const double sink =
        resting_sink(position_column(masses, 0.0), steps ? count : 1, steps ? 1 : count);
    if (1000 * sink < 1e-3)
    {
      break;
    }
    points.emplace_back(count, 1000 * sink);
  }
  return points;
}

/// Ten boxes, and a heavy one on a light one.
inline plot::Chart budget_figure()
{
  plot::Chart chart(
      "position_based", "", {"small steps × passes, in a frame", plot::Scale::log},
      {"the top rests too low by [mm]", plot::Scale::log});
  chart.describe("The sink of columns at rest: a quarter for twice the small steps.")
      .legend(plot::Legend::below);
  const std::vector<double> two{1, 1}, ten(10, 1.0);
  chart
      .line(
          "10 boxes, small steps", sink_by_budget(ten, true),
          {plot::Ink::a, plot::Marker::circle, plot::Stroke::solid})
      .line(
          "10 boxes, passes", sink_by_budget(ten, false),
          {plot::Ink::a, plot::Marker::circle, plot::Stroke::dashed})
      .line(
          "2 boxes, small steps", sink_by_budget(two, true),
          {plot::Ink::b, plot::Marker::square, plot::Stroke::solid})
      .line(
          "2 boxes, passes", sink_by_budget(two, false),
          {plot::Ink::b, plot::Marker::square, plot::Stroke::dashed});
  return chart;
}

/// The farthest [mm] that a cube of a tower is from its place after 3 s, against the passes in a
/// frame.
template <class MethodOf>
std::vector<Eigen::Vector2d> way_by_budget(int cubes, const MethodOf& method_of)
{
  std::vector<Eigen::Vector2d> points;
  for (int count = 4; count <= 64; count *= 2)
  {
    const Scene tower = scenes::tower(cubes);
    GameWorld world(tower, method_of(count).solver());
    while (world.time() < 3)
    {
      world.step();
    }
    const FarthestMove most = farthest_move(tower, world);
    points.emplace_back(count, 1000 * std::hypot(most.along, most.sideways));
  }
  return points;
}

/// How far [mm] a cube of a tower sinks within 3 s in a world, against the small steps in a frame.
inline std::vector<Eigen::Vector2d> sink_by_steps(int cubes)
{
  std::vector<Eigen::Vector2d> points;
  for (int count = 5; count <= 40; count *= 2)
  {
    const Scene tower = scenes::tower(cubes);
    GameWorld world(tower, position_method(count, 1).solver());
    while (world.time() < 3)
    {
      world.step();
    }
    points.emplace_back(count, 1000 * farthest_move(tower, world).along);
  }
  return points;
}

/// Five cubes in a world, by impulses and by positions.
inline plot::Chart tower_figure()
{
  plot::Chart chart(
      "position_based_tower", "", {"passes in a frame", plot::Scale::log},
      {"a cube is off its place by [mm]", plot::Scale::log});
  chart.describe("Five cubes after 3 s: small steps leave least, for the same number of passes.")
      .legend(plot::Legend::below)
      .line(
          "impulses, cold", way_by_budget(5, [](int n) { return impulse_method(false, n); }),
          {plot::Ink::overlap, plot::Marker::cross, plot::Stroke::dotted})
      .line(
          "impulses, warm", way_by_budget(5, [](int n) { return impulse_method(true, n); }),
          {plot::Ink::b, plot::Marker::square, plot::Stroke::dash_dot})
      .line(
          "positions, passes", way_by_budget(5, [](int n) { return position_method(1, n); }),
          {plot::Ink::series3, plot::Marker::triangle, plot::Stroke::dashed})
      .line(
          "positions, small steps", way_by_budget(5, [](int n) { return position_method(n, 1); }),
          {plot::Ink::a, plot::Marker::circle, plot::Stroke::solid});
  return chart;
}

} // namespace cookbook
