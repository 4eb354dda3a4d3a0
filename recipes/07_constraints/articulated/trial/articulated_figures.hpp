#pragma once

/// \file
/// \brief The figures of trees of links: a trace, a swing, the three passes, a chain too taut.

#include "05_resolution/integrators/integrators.hpp"
#include "07_constraints/articulated/double_pendulum.hpp"
#include "07_constraints/articulated/trial/articulated_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// What the end of a double pendulum draws in four seconds, and the pendulum at the end.
inline plot::Figure2d trace_figure()
{
  plot::Figure2d figure("articulated_trace", "", {{-1.15, -1.15}, {1.15, 1.15}, 420});
  figure.describe("The trace of the end of a double pendulum, which was let go above its hook.");
  const SwingingLink rod{.mass = 1, .moment = 0.02, .center = 0.25, .length = 0.5};
  const DoublePendulum pendulum{rod, rod};
  const auto accelerations = [&](const Vector2<double>& angles, const Vector2<double>& speeds)
  { return angular_accelerations(pendulum, angles, speeds); };
  const auto below = [](double angle) -> Vector2<double> {
    return {0.5 * sine(angle), -0.5 * cosine(angle)};
  };
  PhasePoint<Vector2<double>> at{{2, 2.5}, {0, 0}};
  std::vector<Vector2<double>> trace;
  for (int step = 0; step <= 4000; ++step)
  {
    if (step % 10 == 0)
    {
      trace.push_back(below(at.position.x()) + below(at.position.y()));
    }
    at = rk4(at, 0.001, accelerations);
  }
  const Vector2<double> hook(0, 0), elbow = below(at.position.x());
  const Vector2<double> end = elbow + below(at.position.y());
  figure.polyline(trace, plot::Ink::b, plot::Stroke::solid, 1.2)
      .segment(hook, elbow, plot::Ink::a, plot::Stroke::solid, 5)
      .segment(elbow, end, plot::Ink::a, plot::Stroke::solid, 5)
      .point(hook, plot::Ink::ink, "hook", plot::Side::above)
      .dot(elbow, plot::Ink::ink)
      .dot(trace.front(), plot::Ink::ink, "let go here");
  return figure;
}

/// A chain that was let go at 45°, every .56 s of its first swing.
inline plot::Figure2d swing_figure()
{
  plot::Figure2d figure("articulated_swing", "", {{-8.6, -11.2}, {8.6, 0.9}, 560});
  figure.describe("A chain of 20 links, six times within a swing from 45°.");
  ArticulatedBody tree(chain_links({}));
  TreeState state = zero_state(tree.links());
  state.positions[0] = std::numbers::pi / 4;
  const int times = 6, between = 140; // steps of 4 ms
  for (int i = 0; i < times; ++i)
  {
    std::vector<Vector2<double>> joints{{0, 0}};
    const std::vector<LinkBody> bodies = link_bodies(tree, state);
    for (const LinkBody& body : bodies)
    {
      const Vector3<double> end =
          body.motion.center - body.orientation * Vector3<double>(0, 0.25, 0);
      joints.push_back(end.head<2>());
    }
    figure.polyline(joints, plot::Ink::a, plot::Stroke::solid, 2)
        .dot(joints.back(), plot::Ink::b, number(i * between * 0.004) + " s", plot::Side::below);
    for (int step = 0; step < between; ++step)
    {
      rk4_step(tree, state, 0.004);
    }
  }
  figure.point({0, 0}, plot::Ink::ink, "hook", plot::Side::above);
  return figure;
}

/// One pass over three links: arrows outwards or inwards, and what they carry.
inline plot::Figure2d
pass_panel(const std::string& name, bool outwards, const std::vector<std::string>& carried)
{
  plot::Figure2d figure("pass", name, {{-0.7, -3.4}, {2.3, 0.5}, 212});
  const std::vector<Vector2<double>> joints{{0, 0}, {0.35, -1}, {0.7, -2}, {1.05, -3}};
  figure.half_plane({0, -1}, -0.1, plot::Ink::muted);
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
  {
    const Vector2<double> along = joints[i + 1] - joints[i], middle = joints[i] + along / 2;
    figure.capsule(joints[i], joints[i + 1], 0.13, plot::Ink::a);
    const Vector2<double> beside(0.36, 0.12);
    const Vector2<double> upper = middle + beside - 0.38 * along;
    const Vector2<double> lower = middle + beside + 0.38 * along;
    figure.arrow(outwards ? upper : lower, outwards ? lower : upper, plot::Ink::b)
        .label(middle + beside + Vector2<double>(0.08, 0), carried[i], plot::Side::right);
  }
  for (std::size_t i = 0; i + 1 < joints.size(); ++i)
  {
    figure.dot(joints[i]);
  }
  return figure;
}

/// The three passes side by side.
inline plot::Grid passes_figure()
{
  plot::Grid grid("articulated_passes", "", 3);
  grid.describe("Three passes: velocities outwards, inertias inwards, accelerations outwards.")
      .add(pass_panel("1  outwards", true, {"x_{1}, v_{1}", "x_{2}, v_{2}", "x_{3}, v_{3}"}))
      .add(pass_panel("2  inwards", false, {"I_{1}, f_{1}", "I_{2}, f_{2}", "I_{3}, f_{3}"}))
      .add(pass_panel("3  outwards", true, {"a_{1}", "a_{2}", "a_{3}"}));
  return grid;
}

/// The largest energy so far of a nudged chain under 1,000 kg, by two to four steps a frame.
inline plot::Chart tension_figure()
{
  plot::Chart chart(
      "articulated_tension", "", {"time [s]", {}, 0, 1},
      {"largest energy so far, of the nudge's", plot::Scale::log, 0.1, 1e8});
  chart.describe("The energy of a nudged chain under 1,000 kg, by two to four steps a frame.");
  for (const int steps : {2, 3, 4})
  {
    ArticulatedBody tree(chain_links({.load = 1000}));
    TreeState state = zero_state(tree.links());
    const double rest = balance_of(tree, state).energy;
    state.velocities[10] = 0.001;
    const double nudge = balance_of(tree, state).energy - rest;
    std::vector<Vector2<double>> points{{0, 1}};
    for (int frame = 1; frame <= 60; ++frame)
    {
      for (int step = 0; step < steps; ++step)
      {
        semi_implicit_step(tree, state, 1 / (60.0 * steps));
      }
      const double energy = (balance_of(tree, state).energy - rest) / nudge;
      const double most = std::max(points.back().y(), energy);
      if (most > 1e8)
      {
        break;
      }
      points.push_back({frame / 60.0, most});
    }
    plot::Look look = plot::series_look(static_cast<std::size_t>(steps - 2));
    look.marker = plot::Marker::none;
    chart.line(std::to_string(steps) + " steps a frame", points, look);
  }
  return chart.legend(plot::Legend::below);
}

} // namespace cookbook
