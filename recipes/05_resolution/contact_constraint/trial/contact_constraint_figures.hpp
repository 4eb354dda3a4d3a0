#pragma once

/// \file
/// \brief The figures of contacts solved in turn: how errors shrink with passes, and with frames.

#include "05_resolution/contact_constraint/trial/columns.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/plot/panel.hpp"
#include "tools/program/table.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// Three spheres, and the impulses of their contacts after some passes, in weights of a sphere.
inline plot::Figure2d column_panel(const std::string& title, int passes)
{
  Column<double> column = column_of<double>({1, 1, 1});
  solve_frame(column, 1.0, passes, false);
  plot::Figure2d figure("column", title, {{-0.9, -0.3}, {1.3, 3.2}, 150});
  figure.half_plane({0, 1}, 0);
  for (int i = 0; i < 3; ++i)
  {
    const double impulse = column.contacts[std::size_t(i)].impulse;
    const Eigen::Vector2d contact(0, i);
    figure.circle({0, i + 0.5}, 0.48, plot::Ink::muted, plot::Fill::none)
        .arrow(contact, contact + Eigen::Vector2d(0, 0.28 * impulse), plot::Ink::a)
        .label({0.55, i}, rounded(impulse), plot::Side::right, plot::Ink::a);
  }
  return figure;
}

/// The same after one, two, five and a hundred passes.
inline plot::Grid column_figure()
{
  plot::Grid grid("contact_constraint_passes", "", 4);
  grid.describe("The impulses in a column of three spheres after more and more passes.")
      .add(column_panel("1 pass", 1))
      .add(column_panel("2 passes", 2))
      .add(column_panel("5 passes", 5))
      .add(column_panel("100 passes", 100));
  return grid;
}

/// Values numbered from one, as points of a chart, times a factor.
inline std::vector<Eigen::Vector2d>
numbered_points(const std::vector<double>& values, double factor)
{
  std::vector<Eigen::Vector2d> points;
  for (const double value : values)
  {
    points.emplace_back(points.size() + 1, factor * value);
  }
  return points;
}

/// Two spheres of three mass ratios, and columns of two heights.
inline plot::Chart passes_figure()
{
  plot::Chart chart(
      "contact_constraint", "", {"passes, without warm starting", plot::Scale::log, 1, 1000},
      {"error of the impulses [%]", plot::Scale::log, 1e-3, 100});
  chart.describe("The error of the impulses in a column against the number of passes.")
      .legend(plot::Legend::below)
      .reference_y(1, "1 %");
  const auto line = [&](const std::string& name, const std::vector<double>& masses)
  { chart.line(name, numbered_points(errors_by_pass(masses, 2e-5, 1000), 100)); };
  line("1 kg on 1 kg", {1, 1});
  line("10 kg on 1 kg", {1, 10});
  line("100 kg on 1 kg", {1, 100});
  line("5 equal spheres", std::vector<double>(5, 1.0));
  line("20 equal spheres", std::vector<double>(20, 1.0));
  return chart;
}

/// Ten spheres with 10 passes a frame, with and without warm starting.
inline plot::Chart frames_figure()
{
  plot::Chart chart(
      "contact_constraint_frames", "", {"frame", plot::Scale::linear, 0, 60},
      {"the top sphere sinks at [m/s]", plot::Scale::linear, -0.2, 1});
  chart.describe("Ten spheres: without warm starting the top sinks for ever; with it, it rests.")
      .size(560, 320)
      .line(
          "without warm starting", numbered_points(sink_velocities(10, 10, 60, false), 1),
          {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "with warm starting", numbered_points(sink_velocities(10, 10, 60, true), 1),
          {plot::Ink::a, plot::Marker::none, plot::Stroke::solid});
  return chart;
}

} // namespace cookbook
