#pragma once

/// \file
/// \brief Towers on soft contacts around the height at which they bend, R35.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/soft_steps/tallest_tower.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

// [lean]
/// The frequency [Hz] of the springs with so many small steps in a frame of a sixtieth of a second.
inline double frequency_under(int substeps)
{
  return SoftSettings{}.frequency * 60 * substeps;
}

/// How many unit cubes stand on each other; R35.
inline double tallest_under(int substeps)
{
  return tallest_tower(1.0, frequency_under(substeps), 9.81);
}

/// How far [m] any body of a scene has gone aside after 20 s of soft steps: the top of a tower,
/// while it stands.
inline double lean(const Scene& scene, const SoftSettings& how)
{
  GameWorld world(scene, soft_solver(how));
  for (int frame = 0; frame < 20 * 60; ++frame)
  {
    world.step();
  }
  return farthest_move(scene, world).sideways;
}

/// The same of a tower of unit cubes whose arms turn with them.
inline double lean(int cubes, int substeps)
{
  const Scene scene = named_scene("tower_" + std::to_string(cubes));
  return lean(scene, {.substeps = substeps, .anchor_lag = 0});
}
// [lean]

/// A tower that was run.
struct Leaning
{
  int cubes;
  double aside; ///< [m], after 20 s
};

/// The towers within a sixth of the height of R35, the lowest first.
inline std::vector<Leaning> leaning_towers(int substeps)
{
  const double most = tallest_under(substeps);
  std::vector<Leaning> all;
  for (int cubes = int(std::ceil(most * 5 / 6)); cubes <= int(most * 7 / 6); ++cubes)
  {
    all.push_back({cubes, lean(cubes, substeps)});
  }
  return all;
}

/// The highest of these towers whose top, as that of all lower ones, has gone less than half an
/// edge aside; 0 if none.
inline int highest_upright(const std::vector<Leaning>& towers)
{
  int highest = 0;
  for (const Leaning& tower : towers)
  {
    if (tower.aside >= 0.5)
    {
      break;
    }
    highest = tower.cubes;
  }
  return highest;
}

/// The lean over the height, for each number of substeps.
inline plot::Chart
lean_chart(const std::vector<int>& substeps, const std::vector<std::vector<Leaning>>& all)
{
  plot::Chart chart(
      "tall_towers", "", {"height of the tower, in parts of (R35)"},
      {"gone aside after 20 s [m]", plot::Scale::log});
  chart.describe(
      "A twentieth below the formula towers stand for 20 s, a twentieth above they have fallen.");
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::vector<Eigen::Vector2d> line;
    for (const Leaning& one : all[i])
    {
      line.emplace_back(one.cubes / tallest_under(substeps[i]), one.aside);
    }
    chart.line(std::to_string(substeps[i]) + " substeps", line);
  }
  chart.reference_x(1, "(R35)");
  chart.reference_y(0.5, "half an edge");
  return chart;
}

/// Where a spring between two points is drawn: there and back across its length.
inline std::vector<Eigen::Vector2d> zigzag(const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = to - from;
  std::vector<Eigen::Vector2d> points{from};
  for (int i = 1; i <= 7; ++i)
  {
    points.emplace_back(from + along * (i / 8.0) + Eigen::Vector2d(i % 2 == 0 ? 0.05 : -0.05, 0));
  }
  points.push_back(to);
  return points;
}

/// Two cubes with springs between their corners, the upper one leaning.
inline plot::Figure2d joint_figure()
{
  plot::Figure2d figure("tall_towers_joint", "", {{-1.5, -0.85}, {1.7, 2.05}, 420});
  figure.describe("A cube that leans on another presses one pair of corners together.");
  const double lean = -0.17;
  const Eigen::Rotation2Dd turned(lean);
  const Eigen::Vector2d middle(0, 0.85), centre = middle + turned * Eigen::Vector2d(0, 0.5);
  figure.box({0, 0}, 0, {0.5, 0.5}, plot::Ink::a).box(centre, lean, {0.5, 0.5}, plot::Ink::b);
  for (const double side : {-0.5, 0.5})
  {
    const Eigen::Vector2d high = middle + turned * Eigen::Vector2d(side, 0);
    figure.polyline(zigzag({side, 0.5}, high), plot::Ink::overlap);
  }
  figure.segment(middle, middle + Eigen::Vector2d(0, 1.1), plot::Ink::muted, plot::Stroke::dotted);
  figure.segment(middle, middle + turned * Eigen::Vector2d(0, 1.1), plot::Ink::muted);
  figure.angle(middle, 0.8, std::numbers::pi / 2 + lean, std::numbers::pi / 2, "θ");
  figure.dimension({-0.5, -0.5}, {0.5, -0.5}, "a", -18);
  figure.label({0.62, 0.68}, "S", plot::Side::right, plot::Ink::overlap);
  return figure;
}

/// A cube that leans on another, and the push on it as it is given: at an arm that has turned with
/// it, or at one that was kept.
inline plot::Figure2d lever_figure()
{
  plot::Figure2d figure("lagged_arms", "", {{-1.5, -0.35}, {1.5, 1.95}, 420});
  figure.describe("A push at an arm that turns with a leaning cube turns it farther.");
  const double lean = -0.3;
  const Eigen::Rotation2Dd turned(lean);
  const Eigen::Vector2d contact(0, 0.5), centre = contact + turned * Eigen::Vector2d(0, 0.5);
  const Eigen::Vector2d kept = centre - Eigen::Vector2d(0, 0.5), push(0, 0.55);
  figure.box({0, 0}, 0, {0.5, 0.5}, plot::Ink::a).box(centre, lean, {0.5, 0.5}, plot::Ink::b);
  figure.arrow(contact - push, contact, plot::Ink::overlap, "push");
  figure.segment(contact, contact + 2.4 * push, plot::Ink::overlap, plot::Stroke::dotted);
  figure.segment(centre, contact).segment(centre, kept, plot::Ink::muted, plot::Stroke::dashed);
  figure.dot(centre, plot::Ink::ink, "centre", plot::Side::right);
  figure.point(contact, plot::Ink::overlap, "arm turned", plot::Side::left);
  figure.point(kept, plot::Ink::muted, "arm kept", plot::Side::right);
  figure.dimension(
      contact + 2.2 * push,
      contact + 2.2 * push + (centre - contact).x() * Eigen::Vector2d::UnitX(), "lever", 0);
  return figure;
}

} // namespace cookbook
