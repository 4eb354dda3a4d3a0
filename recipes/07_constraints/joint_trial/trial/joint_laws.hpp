#pragma once

/// \file
/// \brief What is measured of pendulums, of pairs in space and of towers.

#include "05_resolution/integrators/trial/pendulum.hpp"
#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/hanging_chain.hpp"
#include "07_constraints/joint_trial/trial/joint_trial.hpp"

#include <cmath>

namespace cookbook
{

// [joint_laws]
/// By which fraction the period of a pendulum is off, let go at an angle with this sine and cosine,
/// over 20 s; the closed form is R31, with the moment of the ball.
inline double period_off(const JointRun& run, double sine, double cosine)
{
  const double right =
      pendulum_period(Pendulum<double>{9.81, 1 + 0.4 * 0.01}, std::atan2(sine, cosine));
  double first = -1, last = -1, before = sine, time = 0;
  int crossings = 0;
  const auto look = [&](GameWorld& world)
  {
    const double x = world.body(1).motion.center.x();
    time += 1.0 / 60;
    if ((x > 0) != (before > 0))
    {
      last = time - x / (x - before) / 60;
      first = first < 0 ? last : first;
      ++crossings;
    }
    before = x;
  };
  run_joints(run, pendulum_of(sine, cosine), 1200, look);
  return std::abs(2 * (last - first) / (crossings - 1) / right - 1);
}

/// What of the momenta of two bodies in space changes in 5 s: linear, angular, as fractions.
struct MomentaOff
{
  double linear, angular, energy;
};
inline MomentaOff momenta_off(const JointRun& run)
{
  const JointedScene pair = tumbling_pair_of();
  int frame = 0;
  Vector3<double> linear_first, linear, angular_first, angular;
  double energy_first = 0, energy_now = 0;
  run_joints(
      run, pair, 301,
      [&](GameWorld& world)
      {
        linear = momentum(world.bodies());
        angular = angular_momentum(world.bodies());
        energy_now = energy(world);
        if (++frame == 1) // which has brought the anchors' speeds together
        {
          linear_first = linear;
          angular_first = angular;
          energy_first = energy_now;
        }
      });
  return {
      (linear - linear_first).norm() / linear_first.norm(),
      (angular - angular_first).norm() / angular_first.norm(), energy_now / energy_first};
}

/// By how much [m] the topmost cube of a tower of ten has sunk after so many frames.
inline double tower_sink_of(const JointRun& run, int frames = 180)
{
  const int steps = run.method.steps(run.count);
  Scene scene = tower_of_ten();
  scene.step = 1.0 / (60 * steps);
  GameWorld world(scene, run.method.solver(run.count));
  for (int step = 0; step < frames * steps; ++step)
  {
    world.step();
  }
  return 9.5 - world.body(10).motion.center.y();
}

/// Where [m] the load of the swung chain is after a second: the same chain as a tree of links,
/// whose joints cannot come apart, by RK4 in steps of 1/960 s.
inline Vector3<double> swung_load()
{
  ArticulatedBody tree(chain_links({.half_extents = {0.05, 0.25, 0.05}, .load = 100}));
  TreeState state = zero_state(tree.links());
  state.positions[0] = std::atan(1.0);
  for (int step = 0; step < 960; ++step)
  {
    rk4_step(tree, state, 1.0 / 960);
  }
  return link_bodies(tree, state).back().motion.center;
}

/// How far [m] a solver has that load from there.
inline double swing_off(const JointRun& run)
{
  static const Vector3<double> right = swung_load();
  Vector3<double> load(0, 0, 0);
  const auto look = [&](GameWorld& world) { load = world.body(21).motion.center; };
  return run_joints(run, swung_chain(), 60, look) ? (load - right).norm() : joint_fails;
}
// [joint_laws]

} // namespace cookbook
