#pragma once

/// \file
/// \brief The figures of the small world: what each step does with the scene that the one before
/// fails.

#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_4.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/step_7.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/plot/figures/figure3d.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cookbook::small_world
{

/// The bodies of a world after a time [s], in a picture so wide [m] around a point.
template <class World>
plot::Figure3d picture(const std::string& title, World world, double time, const plot::Frame& part)
{
  run(world, time);
  plot::Figure3d figure("small_world", title, {0.35, 0.2, 320, 300, 12});
  figure.frame(part);
  figure.plane({0, 0, 0}, {0, 1, 0}, 0.45 * part.width, 8);
  for (std::size_t i = 1; i < world.bodies.size(); ++i)
  {
    const RigidBody& body = world.bodies[i];
    const plot::Ink ink = i % 2 == 0 ? plot::Ink::a : plot::Ink::b;
    figure.box(body.motion.center, body.orientation.toRotationMatrix(), body.half_extents, ink);
  }
  return figure;
}

/// Two pictures beside each other.
inline plot::Grid
beside(const std::string& text, const plot::Figure3d& left, const plot::Figure3d& right)
{
  plot::Grid grid("small_world", "", 2);
  grid.describe(text).add(left).add(right);
  return grid;
}

/// A tower of five at the start and after 20 s.
inline plot::Grid first_figure()
{
  const plot::Frame part{{0, 2.6, 0}, 7};
  return beside(
      "A tower of five cubes under step 1: it stands after 20 s.",
      picture("at the start", tower<step_1::World>(5), 0, part),
      picture("after 20 s", tower<step_1::World>(5), 20, part));
}

/// A pyramid of 55 cubes under steps 1 and 2.
inline plot::Grid pyramids_figure()
{
  const plot::Frame part{{0, 4.5, 0}, 17};
  return beside(
      "A pyramid of 55 cubes after 7.5 s: it collapses under step 1 and stands under step 2.",
      picture("step 1, after 7.5 s", pyramid<step_1::World>(10), 7.5, part),
      picture("step 2, after 7.5 s", pyramid<step_2::World>(10), 7.5, part));
}

/// A tower of ten under steps 2 and 3.
inline plot::Grid towers_figure()
{
  const plot::Frame part{{0, 4.8, 0}, 14};
  return beside(
      "A tower of ten cubes after 27.5 s: it falls under step 2 and stands under step 3.",
      picture("step 2, after 27.5 s", tower<step_2::World>(10), 27.5, part),
      picture("step 3, after 27.5 s", tower<step_3::World>(10), 27.5, part));
}

/// The pairs of bodies that are held against each other, by the number of cubes on a floor.
inline plot::Chart pairs_figure()
{
  std::vector<Eigen::Vector2d> all, swept;
  for (const int side : {5, 10, 20, 40})
  {
    const step_4::World world = floor_of_cubes<step_4::World>(side);
    const double cubes = side * side, count = static_cast<double>(world.bodies.size());
    all.emplace_back(cubes, count * (count - 1) / 2);
    swept.emplace_back(cubes, static_cast<double>(pairs_compared(world.bodies)));
  }
  plot::Chart chart(
      "small_world", "", {"cubes on a floor", plot::Scale::log, 20, 2000},
      {"pairs compared in a step", plot::Scale::log, 30, 3e6});
  chart.describe("Pairs of bodies compared in a step: all of them, and those of sort and sweep.")
      .size(560, 320)
      .line("step 3: every pair", all, {plot::Ink::overlap, plot::Marker::circle})
      .line("step 4: sort and sweep", swept, {plot::Ink::a, plot::Marker::square});
  return chart;
}

/// What is measured of a world after each frame of a time [s].
template <class World, class Measure>
std::vector<Eigen::Vector2d> in_frames(World world, double time, const Measure& measure)
{
  std::vector<Eigen::Vector2d> points;
  for (double now = frame; now < time; now += frame)
  {
    step(world, frame);
    points.emplace_back(now, measure(world));
  }
  return points;
}

/// The last body's place along an axis over time [s], until a time.
template <class World>
std::vector<Eigen::Vector2d> path(const World& world, int axis, double time, double minus)
{
  const auto place = [&](const World& now)
  { return now.bodies.back().motion.center[axis] - minus; };
  std::vector<Eigen::Vector2d> points = in_frames(world, time, place);
  points.insert(points.begin(), {0, place(world)});
  return points;
}

/// The height of a dropped sphere under steps 4 and 5.
inline plot::Chart bounces_figure()
{
  plot::Chart chart(
      "small_world", "", {"time [s]", plot::Scale::linear, 0, 2},
      {"height [m]", plot::Scale::linear, 0, 1.1});
  chart.describe("The height of a sphere dropped from 1 m with e = 0.5: step 4 loses the bounce.")
      .size(560, 320)
      .line(
          "step 4", path(dropped_sphere<step_4::World>(1, 0.5), 1, 2, 0.1),
          {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "step 5", path(dropped_sphere<step_5::World>(1, 0.5), 1, 2, 0.1),
          {plot::Ink::a, plot::Marker::none})
      .reference_y(0.25, "e² · 1 m");
  return chart;
}

/// The contact points that a world solves in each frame of a time [s].
template <class World>
std::vector<Eigen::Vector2d> points_in_frames(const World& world, double time)
{
  return in_frames(
      world, time, [](const World& now) { return static_cast<double>(now.contacts.size()); });
}

/// The contact points of the floor of 400 cubes under steps 5 and 6.
inline plot::Chart points_figure()
{
  plot::Chart chart(
      "small_world", "", {"time [s]", plot::Scale::linear, 0, 1.5},
      {"contact points solved", plot::Scale::linear, 0, 1800});
  chart.describe("The contact points that are solved: step 6 puts the floor to sleep.")
      .size(560, 320)
      .line(
          "step 5", points_in_frames(floor_of_cubes<step_5::World>(20), 1.5),
          {plot::Ink::overlap, plot::Marker::none, plot::Stroke::dashed})
      .line(
          "step 6", points_in_frames(floor_of_cubes<step_6::World>(20), 1.5),
          {plot::Ink::a, plot::Marker::none});
  return chart;
}

/// The way of a shot at a thin wall under steps 6 and 7.
inline plot::Chart shots_figure()
{
  plot::Chart chart(
      "small_world", "", {"time [s]", plot::Scale::linear, 0, 0.15},
      {"x [m]", plot::Scale::linear, -3, 3});
  chart.describe("A sphere shot at a wall of 2 cm at 30 m/s: step 6 lets it through.")
      .size(560, 320)
      .line(
          "step 6", path(shot_at_wall<step_6::World>(30), 0, 0.15, 0),
          {plot::Ink::overlap, plot::Marker::cross, plot::Stroke::dashed})
      .line(
          "step 7", path(shot_at_wall<step_7::World>(30), 0, 0.15, 0),
          {plot::Ink::a, plot::Marker::circle})
      .reference_y(0, "the wall");
  return chart;
}

} // namespace cookbook::small_world
