#pragma once

/// \file
/// \brief How deep a cube gets into the ground that comes down fast.

#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "tools/plot/charts/chart.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// The deepest [m] that a cube of an edge [m] is in the ground in 10 steps, if it comes down flat
/// at a speed [m/s] and would reach the ground after a fraction of the first step.
inline double impact_depth(double edge, double speed, double fraction, const std::string& solver)
{
  Scene scene{.bodies = {ground()}};
  const Vector3<double> half = Vector3<double>::Constant(edge / 2);
  const double separation = fraction * speed * scene.step;
  scene.bodies.push_back(box_body("cube", half, {0, edge / 2 + separation, 0}));
  scene.bodies.back().velocity.y() = -speed;
  const WorldRun run =
      run_world(scene, {.solver = solver, .duration = 10 * scene.step, .keeps_frames = true});
  double deepest = 0;
  for (const Frame& frame : run.frames)
  {
    deepest = std::max(deepest, edge / 2 - frame.bodies[1].position.y());
  }
  return deepest;
}

/// The deepest of twenty such cubes, which differ in how far they have still to go.
inline double deepest_impact(double edge, double speed, const std::string& solver)
{
  double deepest = 0;
  for (int i = 0; i < 20; ++i)
  {
    deepest = std::max(deepest, impact_depth(edge, speed, (i + 0.5) / 20, solver));
  }
  return deepest;
}

/// The deepest impact over the speed, as a fraction of the edge, beside the way of a step.
inline plot::Chart impacts_chart()
{
  plot::Chart chart(
      "game_world_impacts", "", {"speed [m/s]", plot::Scale::log}, {"deepest, in edges [1]"});
  chart.describe(
      "Deepest overlap of a cube of 20 cm with the ground: in the world under a tenth of the edge "
      "at all speeds; looked at after the step it would grow with the speed to half of it.");
  const double edge = 0.2, step = 1.0 / 60;
  std::vector<Eigen::Vector2d> unswept, world;
  for (double speed = 0.5; speed < 101; speed *= std::pow(10, 0.05))
  {
    world.emplace_back(speed, deepest_impact(edge, speed, "direct") / edge);
    if (speed * step < 0.5 * edge)
    {
      unswept.emplace_back(speed, speed * step / edge);
    }
  }
  chart.line("v h: looked at after the step", unswept);
  chart.line("the world", world);
  chart.reference_y(0.1, "a tenth");
  return chart;
}

} // namespace cookbook
