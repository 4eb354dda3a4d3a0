#pragma once

/// \file
/// \brief Stacks, and what each way to solve many contacts makes of them.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/position_based/position_based.hpp"
#include "06_world/position_based/trial/solvers_pitfalls.hpp"
#include "06_world/scenes/trial/stack_scenes.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace cookbook
{

/// A way to solve many contacts.
struct ContactMethod
{
  std::string name;                                ///< such as "warm, 8 passes"
  int passes;                                      ///< over all points, in a frame or a small step
  std::function<IslandSolver(int passes)> slipped; ///< the solver, with some number of passes
  std::string no_factor{}; ///< why its error a pass is not asked, if it is not

  /// The solver as it is named.
  IslandSolver solver() const { return slipped(passes); }
};

/// Sequential impulses, cold or warm.
inline ContactMethod impulse_method(bool warm, int passes)
{
  const auto slipped = [warm](int count) -> IslandSolver
  {
    const SequentialSettings how{.iterations = count, .warm_starting = warm};
    return [how](IslandView world, const Island& island, double step)
    { sequential_impulses(world, island, step, how); };
  };
  const std::string name = warm ? "warm, " : "cold, ";
  return {name + std::to_string(passes) + " passes", passes, slipped};
}

/// Corrected positions.
inline ContactMethod position_method(int substeps, int passes)
{
  const auto slipped = [substeps](int count) -> IslandSolver
  {
    const PositionSettings how{.substeps = substeps, .iterations = count};
    return [how](IslandView world, const Island& island, double step)
    { position_based(world, island, step, how); };
  };
  const std::string name = "positions, " + std::to_string(substeps) + " × ";
  return {name + std::to_string(passes), passes, slipped, substeps == 1 ? "" : "20 steps"};
}

/// The published frame, whatever the passes.
inline ContactMethod published_method()
{
  return {"as published", 5, [](int) -> IslandSolver { return published_frame; }, "no sums"};
}

/// All of them.
inline std::vector<ContactMethod> contact_methods()
{
  return {published_method(),      impulse_method(false, 8), impulse_method(false, 20),
          impulse_method(true, 8), impulse_method(true, 20), position_method(1, 20),
          position_method(20, 1)};
}

/// How far the bodies of a stack have gone from where they began.
struct StackMeasures
{
  double sink = 0;  ///< [m], the most up or down
  double drift = 0; ///< [m], the most sideways
  double tilt = 0;  ///< [rad], the most that a body's y axis leans
  double fell = 0;  ///< [s], when a body was half a metre off its height; 0: never
};

/// Runs a scene for a time [s], or until a body has fallen; the most that was seen at any step.
inline StackMeasures stack_measures(const Scene& scene, const IslandSolver& solver, double duration)
{
  GameWorld world(scene, solver);
  StackMeasures most;
  while (world.time() < duration - scene.step / 2 && most.fell == 0)
  {
    world.step();
    const FarthestMove move = farthest_move(scene, world);
    most.sink = std::max(most.sink, move.along);
    most.drift = std::max(most.drift, move.sideways);
    for (const RigidBody& body : world.bodies())
    {
      most.tilt = std::max(most.tilt, std::acos(std::min(1.0, body.axes(1, 1))));
    }
    most.fell = most.sink > 0.5 ? world.time() : 0;
  }
  return most;
}

/// The same bodies in another order, the ground first.
inline Scene shuffled(Scene scene, unsigned seed)
{
  std::mt19937 random(seed);
  for (std::size_t i = scene.bodies.size() - 1; i > 1; --i)
  {
    std::swap(scene.bodies[i], scene.bodies[1 + random() % i]);
  }
  return scene;
}

/// Where a scene's body of a name is [m] after a time [s].
inline Vector3<double> place_after(
    const Scene& scene, const IslandSolver& solver, double duration, const std::string& name)
{
  GameWorld world(scene, solver);
  while (world.time() < duration - scene.step / 2)
  {
    world.step();
  }
  const auto same = [&](const SceneBody& body) { return body.name == name; };
  const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(), same);
  return world.bodies()[static_cast<std::size_t>(found - scene.bodies.begin())].motion.center;
}

/// How far apart [m] the top of five cubes comes to be in orders of insertion, after 2 s.
inline double order_spread(const IslandSolver& solver, unsigned orders)
{
  const Scene scene = scenes::tower(5);
  const Vector3<double> first = place_after(scene, solver, 2, "box_5");
  double most = 0;
  for (unsigned seed = 1; seed <= orders; ++seed)
  {
    const Vector3<double> place = place_after(shuffled(scene, seed), solver, 2, "box_5");
    most = std::max(most, (place - first).norm());
  }
  return most;
}

/// A ball on a ball of 1 kg, touching.
inline Scene spheres(double ratio)
{
  Scene scene = scenes::standing();
  scene.bodies.push_back(ball_body("light", 0.5, {0, 0.5, 0}));
  scene.bodies.push_back(ball_body("heavy", 0.5, {0, 1.5, 0}, ratio));
  return scene;
}

/// The error [N s] of the impulse between the two after one frame without warm starting.
inline double impulse_missing(const ContactMethod& method, double ratio, int passes)
{
  const Scene scene = spheres(ratio);
  GameWorld world(scene, method.slipped(passes));
  world.step();
  return ratio * 9.81 * scene.step - world.contacts().back().points[0].impulse;
}

/// The factor by which one more pass makes that error smaller; R8.
inline double measured_factor(const ContactMethod& method, double ratio)
{
  return impulse_missing(method, ratio, 6) / impulse_missing(method, ratio, 5);
}

} // namespace cookbook
