#pragma once

/// \file
/// \brief The figures of springs: growth in a step, and energy over time.

#include "07_constraints/springs/trial/spring_measure.hpp"
#include "tools/plot/charts/chart.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// By how much an undamped spring grows in a step: closed forms, and dots that were measured.
inline plot::Chart growth_figure()
{
  plot::Chart chart("springs", "", {"ω·step", {}, 0, 4}, {"growth in a step", {}, 0, 3});
  chart.describe("The growth of an undamped spring in a step, over ω·step, by five ways.");
  const double pi = std::numbers::pi;
  const std::vector<std::function<double(double)>> forms{
      explicit_growth, symplectic_growth, implicit_growth,
      [=](double z) { return exact_growth(z, pi / 2); },
      [=](double z) { return exact_growth(z, pi); }};
  const std::vector<SpringWay> ways = spring_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    plot::Look curve = plot::series_look(i), dot = curve;
    curve.marker = plot::Marker::none;
    std::vector<Eigen::Vector2d> points;
    for (double z = 0; z <= 4; z += 1.0 / 32)
    {
      if (forms[i](z) <= 3)
      {
        points.push_back({z, forms[i](z)});
      }
    }
    chart.line(ways[i].name, points, curve);
    for (double z = 0.25 + 0.05 * static_cast<double>(i); z < 4; z += 0.5)
    {
      const double growth = factors_of(ways[i], {z / (2 * pi), 0, 1}).growth();
      if (growth <= 3)
      {
        chart.point("", {z, growth}, dot);
      }
    }
  }
  return chart.reference_x(2, "h ω = 2").legend(plot::Legend::below);
}

/// The energy of an undamped spring of 5 Hz at 60 steps a second, let go at rest.
inline plot::Chart spring_energy_figure()
{
  plot::Chart chart(
      "springs_energy", "", {"time [s]", {}, 0, 0.5},
      {"energy, of what it was", plot::Scale::log, 1e-2, 1e2});
  chart.describe(
      "The energy of an undamped spring of 5 Hz over half a second at 60 Hz, by five ways.");
  const SpringAsked asked{5, 0, 1.0 / 60};
  const std::vector<SpringWay> ways = spring_ways();
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    PhasePoint<double> at{1, 0};
    const double start = energy_of(at, asked);
    std::vector<Eigen::Vector2d> points{{0, 1}};
    for (int step = 1; step <= 30; ++step)
    {
      at = ways[i].step(at, asked);
      const double energy = energy_of(at, asked) / start;
      if (energy < 1e-2 || energy > 1e2)
      {
        break;
      }
      points.push_back({step / 60.0, energy});
    }
    plot::Look look = plot::series_look(i);
    look.marker = plot::Marker::none;
    chart.line(ways[i].name, points, look);
  }
  return chart.legend(plot::Legend::below);
}

} // namespace cookbook
