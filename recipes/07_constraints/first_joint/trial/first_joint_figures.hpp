#pragma once

/// \file
/// \brief The figures of the first joint: what a step along the tangent adds, and energy over time.

#include "07_constraints/first_joint/trial/rod_swings.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to hold a point on a rod of 1 m.
struct RodWay
{
  std::string name;
  Rod<double> rod;
};

/// From no correction at all to the one of this book.
inline std::vector<RodWay> rod_ways()
{
  return {
      {"velocity only", {1, 0, 0}},
      {"β = 0.2", {1, 0.2, 0}},
      {"β = 1", {1, 1, 0}},
      {"β = 1, and turning", {1, 1, 1}}};
}

/// A step along the tangent of a circle, and what it is off.
inline plot::Figure2d rod_figure()
{
  plot::Figure2d figure("first_joint", "", {{-0.5, -1.3}, {1.25, 0.15}, 600});
  figure.describe("A point on a rod moves along its tangent, and leaves the circle.");
  std::vector<Eigen::Vector2d> circle;
  for (double angle = -0.35; angle <= 1.25; angle += 0.02)
  {
    circle.push_back({std::sin(angle), -std::cos(angle)});
  }
  const double angle = 0.3, ahead = 0.6;
  const Eigen::Vector2d p(std::sin(angle), -std::cos(angle)), tangent(-p.y(), p.x());
  const Eigen::Vector2d next = p + ahead * tangent, held = next.normalized();
  figure.polyline(circle, plot::Ink::muted, plot::Stroke::dashed)
      .segment({0, 0}, p, plot::Ink::a)
      .segment({0, 0}, held, plot::Ink::faint)
      .dot({0, 0}, plot::Ink::ink, "hook", plot::Side::left)
      .dimension(held, next, "C")
      .arrow(p, next, plot::Ink::b, "h v", plot::Side::below)
      .arrow(p, 1.25 * p, plot::Ink::ink, "J", plot::Side::right)
      .point(p, plot::Ink::a, "p", plot::Side::left);
  return figure;
}

/// The energy of a pendulum from 86°, over a minute at 60 Hz.
inline plot::Chart rod_energy_figure()
{
  plot::Chart chart(
      "first_joint_energy", "", {"time [s]", {}, 0, 60}, {"energy of the swing", {}, 0, 1.2});
  chart.describe("The energy of a pendulum over a minute, held on its rod in four ways.");
  const std::vector<RodWay> ways = rod_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& at : rod_swing({.amplitude = 1.5}, ways[i].rod).energy)
    {
      if (at.y() < 0)
      {
        break;
      }
      points.push_back(at);
    }
    plot::Look look = plot::series_look(i);
    look.marker = plot::Marker::none;
    chart.line(ways[i].name, points, look);
  }
  return chart.legend(plot::Legend::below);
}

} // namespace cookbook
