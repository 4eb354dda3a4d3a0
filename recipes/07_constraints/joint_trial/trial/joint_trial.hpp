#pragma once

/// \file
/// \brief What is measured of worlds with joints: how far these come apart, and what is left
/// of energy.

#include "06_world/game_world/trial/world_measures.hpp"
#include "07_constraints/joint_trial/trial/joint_methods.hpp"
#include "07_constraints/joint_trial/trial/joint_scenes.hpp"
#include "07_constraints/taut/trial/taut_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace cookbook
{

/// What a method has made of a scene where a joint came apart by more than a link's
/// length.
inline constexpr double joint_fails = std::numeric_limits<double>::infinity();

// [joint_measures]
/// How far [m] the anchors of a world's joints are apart, at most.
inline double most_apart(GameWorld& world)
{
  return largest_gap(world, world.constraints<BallJoints>(0));
}

/// A method with a count of its own.
struct JointRun
{
  const JointMethod& method;
  int count;
};

/// Runs a scene for so many frames of 1/60 s and looks after each; stops, and returns false, where
/// a joint comes apart by more than half a metre, a link's length: the world keeps what overflows
/// in its place.
inline bool run_joints(
    const JointRun& run, const JointedScene& scene, int frames,
    const std::function<void(GameWorld&)>& look)
{
  const int steps = run.method.steps(run.count);
  GameWorld world = jointed_world(scene, run.method.solver(run.count), 60 * steps);
  for (int step = 1; step <= frames * steps; ++step)
  {
    try
    {
      world.step();
    }
    catch (const std::overflow_error&) // a tree of links keeps nothing in its place
    {
      return false;
    }
    if (!(most_apart(world) < 0.5))
    {
      return false;
    }
    if (step % steps == 0)
    {
      look(world);
    }
  }
  return true;
}

/// How far [m] joints come apart at most in so many frames, but in the first ten; joint_fails where
/// they burst.
inline double stretch_of(const JointRun& run, const JointedScene& scene, int frames = 180)
{
  double most = 0;
  int frame = 0;
  const auto look = [&](GameWorld& world)
  { most = ++frame > 10 ? std::max(most, most_apart(world)) : most; };
  return run_joints(run, scene, frames, look) ? most : joint_fails;
}

/// By how much [m] a body has sunk, as a mean over the last half of so many frames.
inline double
sink_of(const JointRun& run, const JointedScene& scene, std::size_t body, int frames = 180)
{
  double sum = 0;
  int frame = 0;
  const auto look = [&](GameWorld& world)
  { sum += ++frame > frames / 2 ? world.bodies()[body].motion.center.y() : 0; };
  const double start = scene.scene.bodies[body].position.y();
  return run_joints(run, scene, frames, look) ? start - sum / (frames - frames / 2) : joint_fails;
}

/// What is left of the energy of a swing, whose lowest energy [J] is given, after so many frames.
inline double energy_left(const JointRun& run, const JointedScene& scene, double lowest, int frames)
{
  const double start = energy(jointed_world(scene, run.method.solver(run.count)));
  double last = start;
  const auto look = [&](GameWorld& world) { last = energy(world); };
  return run_joints(run, scene, frames, look) ? (last - lowest) / (start - lowest) : joint_fails;
}
// [joint_measures]

} // namespace cookbook
