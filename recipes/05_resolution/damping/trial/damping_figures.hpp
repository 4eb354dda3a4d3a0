#pragma once

/// \file
/// \brief The figures of damping: a fall at three rates, factors over the step, error over rate.

#include "05_resolution/damping/trial/damping_cases.hpp"
#include "tools/plot/charts/chart.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The speed of a fall over 5 s by a way to damp, in so many steps a second.
inline std::vector<Eigen::Vector2d> speeds_over_time(const DampingMethod& method, double rate)
{
  std::vector<Eigen::Vector2d> points{{0, 0}};
  PhasePoint<double> at{0, 0};
  const int steps = static_cast<int>(5 * rate);
  const int skipped = static_cast<int>(rate / 10);
  for (int i = 1; i <= steps; ++i)
  {
    at = method.step(at, thick_air.acceleration, thick_air.rate, 1 / rate);
    if (i % skipped == 0)
    {
      points.push_back({i / rate, std::abs(at.velocity)});
    }
  }
  return points;
}

/// As published, one fall is three; with the rate in the exponent three are one.
inline plot::Chart fall_figure()
{
  plot::Chart chart("damping", "", {"time [s]", {}, 0, 5}, {"speed [m/s]", {}, 0, 16});
  chart.describe("The speed of a damped fall at 30, 60 and 240 steps a second, in two ways.");
  const auto add = [&](const std::string& name, std::size_t method, double rate, std::size_t look)
  {
    plot::Look shown = plot::series_look(look);
    shown.marker = plot::Marker::none;
    chart.line(name, speeds_over_time(damping_methods()[method], rate), shown);
  };
  add("0.98 a step, 30 Hz", 0, 30, 0);
  add("0.98 a step, 60 Hz", 0, 60, 1);
  add("0.98 a step, 240 Hz", 0, 240, 2);
  add("damped_fall, 30 Hz", 5, 30, 3);
  add("the same, 240 Hz", 5, 240, 5);
  return chart;
}

/// What each factor leaves of a velocity in one step.
inline plot::Chart factor_figure()
{
  plot::Chart chart(
      "damping_factor", "", {"c·step", {}, 0, 3}, {"left after one step", {}, -1.5, 1});
  chart.describe("Three damping factors over rate times step.");
  const auto add = [&](const std::string& name, std::size_t look, const auto& factor)
  {
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i <= 60; ++i)
    {
      const double s = i / 20.0;
      const double left = factor(1.0, s);
      if (left >= -1.5)
      {
        points.push_back({s, left});
      }
    }
    plot::Look shown = plot::series_look(look);
    shown.marker = plot::Marker::none;
    chart.line(name, points, shown);
  };
  add("exp(−c·step)", 0, damping_factor<double>);
  add("1/(1 + c·step)", 1, implicit_damping_factor<double>);
  add("1 − c·step", 2, explicit_damping_factor<double>);
  return chart.reference_y(-1, "beyond this it grows");
}

/// The error of the speed after the long fall, over steps a second.
inline plot::Chart error_figure()
{
  plot::Chart chart(
      "damping_error", "", {"steps a second", plot::Scale::log, 3, 1500},
      {"error of the speed after 20 s", plot::Scale::log, 1e-10, 1});
  chart.describe("The error of a damped fall's speed after 20 s, over the number of steps.");
  const double truth = true_speed(long_fall);
  const std::vector<DampingMethod> methods = damping_methods();
  for (std::size_t i = 1; i < methods.size(); ++i)
  {
    std::vector<Eigen::Vector2d> points;
    for (double rate = 4; rate <= 1024; rate *= 2)
    {
      const double speed = damped_end(methods[i], long_fall, rate).velocity;
      const double error = std::abs(speed / truth - 1);
      points.push_back({rate, error < 1e-11 ? 0 : error});
    }
    chart.line(methods[i].name, points);
  }
  return chart;
}

} // namespace cookbook
