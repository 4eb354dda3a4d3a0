#pragma once

/// \file
/// \brief The figures of sequential impulses: how errors shrink with passes, and with frames.

#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Three boxes, and what their contacts have got after some passes from a cold start, in weights.
inline plot::Figure2d stack_panel(const std::string& title, int passes)
{
  const PushProblem<double> problem = column({1, 1, 1}, 1.0);
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(3);
  for (int pass = 0; pass < passes; ++pass)
  {
    correct_in_turn(problem, impulses);
  }
  plot::Figure2d figure("stack", title, {{-0.9, -0.3}, {1.3, 3.2}, 150});
  figure.half_plane({0, 1}, 0);
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector2d contact(0, i);
    figure.box({0, i + 0.5}, 0, {0.5, 0.48}, plot::Ink::muted, plot::Fill::none)
        .arrow(contact, contact + Eigen::Vector2d(0, 0.28 * impulses[i]), plot::Ink::a)
        .label({0.55, i}, rounded(impulses[i]), plot::Side::right, plot::Ink::a);
  }
  return figure;
}

/// The same after one, two, five and a hundred passes.
inline plot::Grid stack_figure()
{
  plot::Grid grid("sequential_impulses_passes", "", 4);
  grid.describe("The impulses in a stack of three boxes after more and more passes.")
      .add(stack_panel("1 pass", 1))
      .add(stack_panel("2 passes", 2))
      .add(stack_panel("5 passes", 5))
      .add(stack_panel("100 passes", 100));
  return grid;
}

/// The error of a cold column's impulses after each pass.
inline std::vector<Eigen::Vector2d> error_by_pass(const std::vector<double>& masses, int passes)
{
  const PushProblem<double> problem = column(masses, 1.0);
  const Eigen::VectorXd right = carrying_impulses(masses, 1.0);
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(right.size());
  std::vector<Eigen::Vector2d> points;
  for (int pass = 1; pass <= passes; ++pass)
  {
    correct_in_turn(problem, impulses);
    const double error = impulse_error(impulses, right);
    if (error < 1e-5)
    {
      break;
    }
    points.emplace_back(pass, 100 * error);
  }
  return points;
}

/// Two bodies of three mass ratios, and towers of two heights.
inline plot::Chart passes_figure()
{
  plot::Chart chart(
      "sequential_impulses", "", {"passes, from a cold start", plot::Scale::log, 1, 1000},
      {"error of the impulses [%]", plot::Scale::log, 1e-3, 100});
  chart.describe("The error of the impulses in a column against the number of passes.")
      .legend(plot::Legend::below)
      .reference_y(1, "1 %");
  for (const double ratio : {1.0, 10.0, 100.0})
  {
    const std::string name = std::to_string(static_cast<int>(ratio));
    chart.line(name + " kg on 1 kg", error_by_pass({1, ratio}, 1000));
  }
  for (const std::size_t count : {5u, 20u})
  {
    const std::vector<double> masses(count, 1.0);
    chart.line(std::to_string(count) + " equal boxes", error_by_pass(masses, 1000));
  }
  return chart;
}

/// How fast [m/s] the top of a column sinks at the end of each frame, if it is at all.
inline std::vector<Eigen::Vector2d>
sinking_by_frame(std::size_t count, int passes, int frames, bool warm)
{
  const PushProblem<double> problem = column(std::vector<double>(count, 1.0), 9.81 / 60);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(problem.speeds.size());
  ColumnFrame<double> frame{zero, zero};
  std::vector<Eigen::Vector2d> points;
  for (int i = 1; i <= frames; ++i)
  {
    frame = next_column_frame(problem, frame, passes, warm);
    points.emplace_back(i, -frame.speeds.sum());
  }
  return points;
}

/// Ten boxes with 8 passes a frame, cold and warm.
inline plot::Chart frames_figure()
{
  plot::Chart chart(
      "sequential_impulses_frames", "", {"frame", plot::Scale::linear, 0, 60},
      {"the top box sinks at [m/s]", plot::Scale::linear, -0.2, 1});
  chart.describe("Ten boxes: cold, the top sinks for ever; warm, it comes to rest.")
      .size(640, 320)
      .line(
          "cold", sinking_by_frame(10, 8, 60, false),
          {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "warm", sinking_by_frame(10, 8, 60, true),
          {plot::Ink::a, plot::Marker::none, plot::Stroke::solid});
  return chart;
}

} // namespace cookbook
