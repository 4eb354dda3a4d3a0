#pragma once

/// \file
/// \brief The figures of sequential impulses: how errors shrink with passes, and with frames.

#include "05_resolution/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "common/plot/charts/chart.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

// [passes_figure]
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
// [passes_figure]

// [frames_figure]
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
// [frames_figure]

} // namespace cookbook
