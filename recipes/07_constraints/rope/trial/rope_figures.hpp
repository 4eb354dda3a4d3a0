#pragma once

/// \file
/// \brief The figures of the ropes: a cable, its error against the work, a swing, its energy.

#include "07_constraints/rope/trial/rope_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The particles of a rope in the plane of its motion.
inline std::vector<Eigen::Vector2d> outline(const Rope& rope)
{
  std::vector<Eigen::Vector2d> points;
  for (const Vector3<double>& x : rope.particles.positions)
  {
    points.push_back({x.x(), x.y()});
  }
  return points;
}

/// Where the cable hangs by a method.
inline Rope hanging_cable(const RopeMethod& method)
{
  Rope rope = cable(method.compliance);
  run_rope(rope, method, 900, 4, [](const Rope&) {});
  return rope;
}

/// The cable by XPBD with one and three iterations, and right.
inline plot::Figure2d cable_figure()
{
  plot::Figure2d figure("rope", "", {{-5.2, -4.15}, {5.2, 0.5}, 640});
  figure.describe(
      "A cable of 10 m between two hooks 8 m apart: with one iteration of XPBD it is a metre too "
      "long, with three 40 cm; solved directly it is right.");
  const std::vector<int> counts{1, 3};
  for (const int iterations : counts)
  {
    const std::vector<Eigen::Vector2d> points = outline(hanging_cable(xpbd(1, iterations)));
    const std::string plural = iterations == 1 ? " iteration" : " iterations";
    figure.polyline(points, plot::Ink::b, plot::Stroke::solid, 1.6);
    figure.label(points[20], std::to_string(iterations) + plural, plot::Side::below, plot::Ink::b);
  }
  const std::vector<Eigen::Vector2d> right = outline(hanging_cable(direct_previous(1, 2)));
  figure.polyline(right, plot::Ink::a, plot::Stroke::solid, 2.4);
  for (const Eigen::Vector2d& at : right)
  {
    figure.dot(at, plot::Ink::a);
  }
  figure.label(right[20], "direct: the catenary", plot::Side::above, plot::Ink::a);
  return figure.point({-4, 0}, plot::Ink::ink, "hook", plot::Side::above)
      .point({4, 0}, plot::Ink::ink, "hook", plot::Side::above);
}

/// A point of the chart of errors: passes a frame, and the error of the sag in millimetres; less
/// than a ten-thousandth counts as none.
inline Eigen::Vector2d error_point(const RopeMethod& method)
{
  const double error = 1000 * std::abs(sag_error(method));
  return {static_cast<double>(method.passes()), error < 1e-4 ? 0 : error};
}

/// The error of the sag against the work of a frame, for each method.
inline plot::Chart error_chart()
{
  plot::Chart chart(
      "rope_error", "", {"passes along the rope a frame", plot::Scale::log, 0.8, 400},
      {"error of the sag [mm]", plot::Scale::log, 1e-4, 2000});
  chart.describe("Passes a frame against the error of a hanging cable's sag, for five methods.");
  std::vector<Eigen::Vector2d> iterations, substeps, implicit, current, previous;
  for (const int count : {1, 3, 10, 30, 100, 300})
  {
    iterations.push_back(error_point(xpbd(1, count)));
    substeps.push_back(error_point(xpbd(count, 1)));
  }
  for (const double stiffness : {1e3, 1e4, 1e5, 1e6, 1e7})
  {
    implicit.push_back(error_point(implicit_euler_of(stiffness)));
  }
  for (const int count : {1, 2, 4, 8, 16})
  {
    current.push_back(error_point(direct_current(count)));
    previous.push_back(error_point(direct_previous(count, 2)));
  }
  return chart.line("XPBD, iterations", iterations)
      .line("XPBD, substeps", substeps)
      .line("implicit Euler, 1e3 to 1e7 N/m", implicit)
      .line("direct, current", current)
      .line("direct, previous", previous)
      .legend(plot::Legend::below)
      .size(640, 480);
}

/// A rope that swings from the horizontal, every twelfth of a second.
inline plot::Figure2d swing_figure()
{
  plot::Figure2d figure("rope_swing", "", {{-5.4, -5.5}, {5.6, 0.9}, 560});
  figure.describe("A rope let go horizontally, in steps of a twelfth of a second for 1.75 s.");
  Rope rope = swing(std::numbers::pi / 2);
  figure.polyline(outline(rope), plot::Ink::muted);
  int frame = 0;
  const auto draw = [&](const Rope& now)
  {
    if (++frame % 5 == 0)
    {
      const plot::Ink ink = frame <= 60 ? plot::Ink::a : plot::Ink::b;
      figure.polyline(outline(now), ink, plot::Stroke::solid, 1.2);
      figure.dot(outline(now).back(), ink);
    }
  };
  run_rope(rope, direct_previous(10, 2), 105, 0, draw);
  return figure.point({0, 0}, plot::Ink::ink, "hook", plot::Side::above);
}

/// What is left of the energy of a swing from 45°.
inline plot::Chart energy_chart()
{
  plot::Chart chart(
      "rope_energy", "", {"time [s]", {}, 0, 10}, {"energy left of the swing", {}, 0, 1.1});
  chart.describe("The energy of a rope that swings from 45 degrees, over 10 s, by six methods.");
  const auto line = [&](const std::string& name, const RopeMethod& method, std::size_t look)
  {
    std::vector<Eigen::Vector2d> points{{0, 1}};
    const std::vector<double> energies = swing_energies(method, std::numbers::pi / 4, 600);
    for (std::size_t frame = 9; frame < energies.size(); frame += 10)
    {
      points.push_back({static_cast<double>(frame + 1) / 60, energies[frame]});
    }
    plot::Look style = plot::series_look(look);
    style.marker = plot::Marker::none;
    chart.line(name, points, style);
  };
  line("direct, previous, 1 substep", direct_previous(1, 2), 4);
  line("XPBD, 100 substeps", xpbd(100, 1), 1);
  line("XPBD, 10 substeps", xpbd(10, 1), 5);
  line("direct, current, 1 substep", direct_current(1, 2), 3);
  line("XPBD, 100 iterations", xpbd(1, 100), 0);
  line("implicit Euler, 1e6 N/m", implicit_euler_of(1e6), 2);
  return chart.legend(plot::Legend::below).size(640, 460);
}

} // namespace cookbook
