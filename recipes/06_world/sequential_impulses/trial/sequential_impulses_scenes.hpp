#pragma once

/// \file
/// \brief Stacks under sequential impulses: whether they stand, and how far a solver is from an
/// answer.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/stack_scenes.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cookbook
{

/// Sequential impulses with these settings, as a solver of a world.
inline IslandSolver sequential_solver(const SequentialSettings& settings)
{
  return [settings](IslandView world, const Island& island, double step)
  { sequential_impulses(world, island, step, settings); };
}

/// What a stack did.
struct StackRun
{
  double sink; ///< [m], the most that a body was off its height
  double fell; ///< [s], when that was half a metre; 0: never
};

/// Runs a stack for a time [s], or until a body has fallen.
inline StackRun run_stack(const Scene& scene, const SequentialSettings& settings, double duration)
{
  GameWorld world(scene, sequential_solver(settings));
  StackRun run{0, 0};
  while (world.time() < duration - scene.step / 2 && run.fell == 0)
  {
    world.step();
    run.sink = std::max(run.sink, farthest_move(scene, world).along);
    run.fell = run.sink > 0.5 ? world.time() : 0;
  }
  return run;
}

// [residuals]
/// The residual [m/s] of a tower of cubes at rest after 0, 1, 2 … passes without warm starting;
/// R10.
inline std::vector<double> residuals(int cubes, int passes)
{
  GameWorld world(scenes::tower(cubes), sequential_solver({.iterations = 100}));
  for (int frame = 0; frame < 60; ++frame)
  {
    world.step();
  }
  std::vector<RigidBody> bodies = world.bodies();
  std::vector<WorldContact> contacts = world.contacts();
  SolverScratch room;
  const IslandView view{bodies, contacts, world.scene().gravity, room};
  Islands islands;
  islands.find(bodies, contacts);
  accelerate(view, std::array{islands[0]}, world.scene().step);
  std::vector<SequentialPoint> points =
      sequential_points(view, islands[0], world.scene().step, {.warm_starting = false});
  std::vector<double> all{complementarity_residual(points)};
  for (int pass = 0; pass < passes; ++pass)
  {
    velocity_pass(points);
    all.push_back(complementarity_residual(points));
  }
  return all;
}
// [residuals]

} // namespace cookbook
