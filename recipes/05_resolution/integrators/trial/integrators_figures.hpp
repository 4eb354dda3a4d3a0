#pragma once

/// \file
/// \brief The figures of the integrators: phase planes, energy over time, cost against error.

#include "05_resolution/integrators/trial/integrators_cost_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// One period of the oscillator in 24 steps, over a circle that is the truth.
inline plot::Figure2d phase_panel(const Integrator<double>& method)
{
  plot::Figure2d figure("phase", method.name, {{-2.8, -2.8}, {2.8, 2.8}, 212});
  figure.axes(1, "x", "v/ω").circle({0, 0}, 1, plot::Ink::muted, plot::Fill::none);
  const double omega = oscillator().pace;
  std::vector<Eigen::Vector2d> points;
  for (const PhasePoint<double>& at : oscillating(method, 1, 24))
  {
    points.push_back({at.position, at.velocity / omega});
    figure.dot(points.back(), plot::Ink::a);
  }
  figure.polyline(points, plot::Ink::a);
  return figure;
}

/// The phase planes of all integrators.
inline plot::Grid phase_figure()
{
  plot::Grid grid("integrators", "", 3);
  grid.describe("One period of an oscillator by six integrators, in the plane of x and v/ω.");
  for (const Integrator<double>& method : integrators<double>())
  {
    grid.add(phase_panel(method));
  }
  return grid;
}

/// How far the energy of the oscillator has ever been off, over time.
inline plot::Chart energy_figure()
{
  plot::Chart chart(
      "integrators_energy", "", {"time [s]", {}, 0, 10},
      {"energy off by, of what it was", plot::Scale::log, {}, 1000});
  chart.describe("The largest error of the oscillator's energy so far, over 10 s at 60 Hz.");
  for (std::size_t i = 0; i < integrators<double>().size(); ++i)
  {
    const Integrator<double> method = integrators<double>()[i];
    const PhasePath<double> course = oscillating(method, 10, game_rate);
    double most = 0;
    std::vector<Eigen::Vector2d> points;
    for (std::size_t step = 1; step < course.size(); ++step)
    {
      most = std::max(most, std::abs(energy_share(course[step]) - 1));
      if (step % 15 == 0)
      {
        const double rounding_is_none = most < 1e-10 ? 0 : most;
        points.push_back({static_cast<double>(step) / game_rate, rounding_is_none});
      }
    }
    plot::Look look = plot::series_look(i);
    look.marker = plot::Marker::none;
    chart.line(method.name, points, look);
  }
  return chart;
}

/// Cost against error for one swing, with the Pareto front; errors down to `least`.
inline plot::Chart
cost_panel(const std::string& name, const std::string& title, const Swing& swing, double least)
{
  plot::Chart chart(
      name, title, {"evaluations a period", plot::Scale::log, 8, 4000},
      {"error after 10¼ periods", plot::Scale::log, least, 10});
  for (const Integrator<double>& method : integrators<double>())
  {
    std::vector<Eigen::Vector2d> points;
    for (const measure::CostAndError& point : cost_curve(swing, method))
    {
      if (point.error < 10)
      {
        points.push_back({point.cost, point.error});
      }
    }
    chart.line(method.name, points);
  }
  std::vector<Eigen::Vector2d> front;
  for (const Choice& choice : best_choices(swing))
  {
    front.push_back({choice.has.cost, choice.has.error});
  }
  return chart.front(front).legend(plot::Legend::below).size(480, 460);
}

/// Both smooth swings side by side.
inline plot::Grid cost_figure()
{
  plot::Grid grid("integrators_cost", "", 2);
  grid.describe("Evaluations of the force against error, for six integrators and two swings.")
      .add(cost_panel("cost", "oscillator", oscillator(), 1e-9))
      .add(cost_panel("cost", "pendulum from 90°", pendulum(), 1e-9));
  return grid;
}

/// The ball on the springy floor.
inline plot::Chart kink_figure()
{
  plot::Chart chart = cost_panel("integrators_kink", "", springy_floor(), 1e-6);
  chart.describe("Evaluations against error, for a ball that bounces on a springy floor.");
  return chart.size(640, 460);
}

} // namespace cookbook
