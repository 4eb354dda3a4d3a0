#pragma once

/// \file
/// \brief The figures of restitution: heights over time, coming to rest, error against cost.

#include "05_resolution/restitution/trial/restitution_scenes.hpp"
#include "tools/plot/charts/chart.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The heights [m] of a flight from one time to another [s], times a scale.
inline std::vector<Eigen::Vector2d>
heights(const std::vector<Flight>& flight, double from, double to, double scale)
{
  std::vector<Eigen::Vector2d> points;
  for (const Flight& row : flight)
  {
    if (row.time >= from && row.time <= to)
    {
      points.emplace_back(row.time, scale * row.height);
    }
  }
  return points;
}

/// The height [m] of a dropped ball at a time [s] in closed form: each bounce lasts e times as long
/// as the one before.
inline double height_by_hand(const Drop& drop, double time)
{
  const double g = drop.gravity;
  double speed = std::sqrt(2 * g * drop.height), begin = -speed / g; // of the flight it is in
  for (int bounce = 0; bounce < 200 && time > begin + 2 * speed / g; ++bounce)
  {
    begin += 2 * speed / g;
    speed *= drop.restitution;
  }
  const double flown = time - begin;
  return std::max(0.0, speed * flown - g * flown * flown / 2);
}

/// The height of a ball under a rule, over that in closed form.
inline plot::Chart drop_chart(const Drop& drop, const BounceRule& rule, double width)
{
  std::vector<Eigen::Vector2d> due;
  for (int i = 0; i <= 400; ++i)
  {
    const double time = drop.duration * i / 400;
    due.emplace_back(time, height_by_hand(drop, time));
  }
  plot::Chart chart(
      "restitution_drop", "", {"time [s]", plot::Scale::linear, 0, drop.duration},
      {"height [m]", plot::Scale::linear, -0.2, 2.2});
  chart.describe("The height of a dropped ball under a rule of restitution, and in closed form.")
      .size(width, 320)
      .legend(plot::Legend::below)
      .line("closed form", due, {plot::Ink::good, plot::Marker::none, plot::Stroke::dashed})
      .line(
          rule.name, heights(flight(drop, rule), 0, drop.duration, 1),
          {plot::Ink::a, plot::Marker::none, plot::Stroke::solid});
  return chart;
}

/// A bounce that loses nothing, by three rules.
inline plot::Chart heights_figure()
{
  const std::vector<BounceRule> rules = bounce_rules();
  const Drop drop{1, 1, 8};
  const auto line = [&](std::size_t rule) { return heights(flight(drop, rules[rule]), 0, 8, 1); };
  plot::Chart chart(
      "restitution", "", {"time [s]", plot::Scale::linear, 0, 8},
      {"height [m]", plot::Scale::linear, -0.2, 1.8});
  chart.describe("The height of a ball that bounces without loss for 8 s, by three rules.")
      .size(760, 360)
      .legend(plot::Legend::below)
      .line(
          "after gravity", line(1), {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "before gravity", line(0), {plot::Ink::series4, plot::Marker::none, plot::Stroke::dotted})
      .line("at the touch", line(4), {plot::Ink::a, plot::Marker::none, plot::Stroke::solid})
      .reference_y(1, "");
  return chart;
}

/// The last bounces of a ball with e = 0.8, and the time by which there is none left.
inline plot::Chart rest_figure()
{
  const std::vector<BounceRule> rules = bounce_rules();
  const Drop drop{1, 0.8, 6};
  const auto line = [&](std::size_t rule)
  { return heights(flight(drop, rules[rule]), 3, 6, 1000); };
  plot::Chart chart(
      "restitution_rest", "", {"time [s]", plot::Scale::linear, 3, 6}, {"height [mm]"});
  chart.describe("The last bounces of a ball with e = 0.8, by two rules.")
      .size(760, 360)
      .legend(plot::Legend::below)
      .line(
          "after gravity, threshold", line(2),
          {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "at the touch, threshold", line(4),
          {plot::Ink::a, plot::Marker::none, plot::Stroke::solid})
      .reference_x(settling_time(drop.height, drop.gravity, drop.restitution), "due at rest");
  return chart;
}

/// The greatest error [m] of the first apex of e = 0.5, of 16 heights from 1 m to 2 m.
inline double apex_error(const BounceRule& rule, double steps_per_second)
{
  double greatest = 0;
  for (int i = 0; i < 16; ++i)
  {
    const Drop drop{1 + i / 16.0, 0.5, 1.6, 1 / steps_per_second};
    const double apex = apexes(flight(drop, rule), drop.gravity).at(0);
    greatest = std::max(greatest, std::abs(apex - drop.height / 4));
  }
  return greatest < 1e-9 ? 0 : greatest;
}

/// The error of the first apex over the steps a second, by three rules.
inline plot::Chart cost_figure()
{
  const std::vector<BounceRule> rules = bounce_rules();
  const auto line = [&](std::size_t rule)
  {
    std::vector<Eigen::Vector2d> points;
    for (double rate = 30; rate <= 2000; rate *= 2)
    {
      points.emplace_back(rate, apex_error(rules[rule], rate));
    }
    return points;
  };
  plot::Chart chart(
      "restitution_cost", "", {"steps a second", plot::Scale::log},
      {"error of the apex [m]", plot::Scale::log});
  chart.describe("The error of a bounce's height over the number of steps a second.")
      .line(
          "before gravity", line(0),
          {plot::Ink::series4, plot::Marker::cross, plot::Stroke::dotted})
      .line(
          "after gravity", line(1),
          {plot::Ink::overlap, plot::Marker::square, plot::Stroke::dashed})
      .line("at the touch", line(4), {plot::Ink::a, plot::Marker::circle, plot::Stroke::solid});
  return chart;
}

} // namespace cookbook
