#pragma once

/// \file
/// \brief The figures of friction: where a block stops, what a slope does, error against cost.

#include "05_resolution/friction/trial/friction_cases.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// The block's way over the floor, seen from above.
inline std::vector<Eigen::Vector2d> path(const FrictionRule& rule, double degrees)
{
  OneContactScene scene = sliding_block(5 * heading(degrees));
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 360; ++i)
  {
    if (i % 12 == 0)
    {
      points.emplace_back(mover(scene).center.x(), mover(scene).center.z());
    }
    advance(scene, rule);
  }
  return points;
}

/// Ten blocks that slide off at 5 m/s, each with a heading of its own, and where they stop.
inline plot::Figure2d paths_panel(const std::string& title, const FrictionRule& rule)
{
  plot::Figure2d figure(title, title, {{-0.25, -0.25}, {3.6, 3.6}, 330});
  std::vector<Eigen::Vector2d> arc;
  for (int i = 0; i <= 90; i += 2)
  {
    const Vector3<double> out = 25 / (2 * 0.4 * 9.81) * heading(i);
    arc.emplace_back(out.x(), out.z());
  }
  figure.polyline(arc, plot::Ink::muted, plot::Stroke::dashed);
  for (int degrees = 0; degrees <= 90; degrees += 10)
  {
    const std::vector<Eigen::Vector2d> way = path(rule, degrees);
    figure.polyline(way, plot::Ink::a).dot(way.back(), plot::Ink::overlap);
  }
  figure.dot({0, 0}, plot::Ink::ink);
  return figure;
}

/// The pyramid beside the cone.
inline plot::Grid paths_figure()
{
  const std::vector<FrictionRule> rules = friction_rules();
  plot::Grid grid("friction", "", 2);
  grid.describe("Ways of blocks over a floor, seen from above, by a friction pyramid and a cone.")
      .add(paths_panel("pyramid", rules[2]))
      .add(paths_panel("cone", rules[3]));
  return grid;
}

/// How far a cube slides in 1 s on slopes of 0° to 45° with μ = 0.6 that fall towards a heading.
inline std::vector<Eigen::Vector2d> slid(const FrictionRule& rule, double towards)
{
  std::vector<Eigen::Vector2d> points;
  for (double slope = 0; slope <= 45; slope += 2.5)
  {
    const double here = way(advanced(cube_on_slope(0.6, slope, towards), rule, 1));
    points.emplace_back(slope, here < 1e-3 ? 0 : here);
  }
  return points;
}

/// The way over the slope, by rule; less than a millimetre counts as none.
inline plot::Chart slopes_figure()
{
  const std::vector<FrictionRule> rules = friction_rules();
  plot::Chart chart(
      "friction_slopes", "", {"slope [°]", plot::Scale::linear, 0, 45},
      {"way in 1 s [m]", plot::Scale::log});
  chart.describe("How far a cube slides in 1 s, over the slope, by rules of friction.")
      .size(760, 400)
      .legend(plot::Legend::below)
      .line(
          "as published", slid(rules[0], 0),
          {plot::Ink::series4, plot::Marker::plus, plot::Stroke::dotted})
      .line(
          "box", slid(rules[1], 0),
          {plot::Ink::series3, plot::Marker::triangle, plot::Stroke::dash_dot})
      .line(
          "pyramid, down its diagonal", slid(rules[2], 45),
          {plot::Ink::overlap, plot::Marker::cross, plot::Stroke::dashed})
      .line("cone", slid(rules[3], 45), {plot::Ink::a, plot::Marker::circle})
      .reference_x(std::atan(0.6) * 180 / std::numbers::pi, "tan θ = μ");
  return chart;
}

/// The error of the way of a block at 5 m/s, as a fraction of the way that these steps ought to
/// give; the greatest of those along an axis of a polygon and along a corner.
inline double way_error(const FrictionRule& rule, int axes)
{
  const OneContactScene still = sliding_block({0, 0, 0});
  const double right = 25 / (2 * 0.4 * 9.81) - 5 * still.step / 2;
  double greatest = 0;
  for (const double degrees : {0.0, 90.0 / axes})
  {
    const double here = way(advanced(sliding_block(5 * heading(degrees)), rule, 1.5));
    greatest = std::max(greatest, std::abs(here / right - 1));
  }
  return greatest;
}

/// The cut to a regular polygon.
inline FrictionRule polygon_rule(int axes)
{
  return {"polygon", [=](const FrictionVisit& at) {
            return within_polygon(at.against(), at.max_friction, axes);
          }};
}

/// The error over the number of scalar products of each visit.
inline plot::Chart cuts_figure()
{
  std::vector<Eigen::Vector2d> polygons;
  for (int axes = 2; axes <= 32; axes *= 2)
  {
    polygons.emplace_back(axes, way_error(polygon_rule(axes), axes));
  }
  plot::Chart chart(
      "friction_cuts", "", {"scalar products a visit", plot::Scale::log, 0.7, 50},
      {"error of the way", plot::Scale::log});
  chart
      .describe("The error of a block's way over the number of scalar products that shorten its "
                "friction.")
      .line("polygon", polygons, {plot::Ink::overlap, plot::Marker::square, plot::Stroke::dashed})
      .point(
          "pyramid", {2, way_error(friction_rules()[2], 2)},
          {plot::Ink::series4, plot::Marker::cross})
      .point("cone", {1, way_error(friction_rules()[3], 3)}, {plot::Ink::a});
  return chart;
}

} // namespace cookbook
