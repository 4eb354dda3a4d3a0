#pragma once

/// \file
/// \brief How far joints of taut scenes come apart, and what is left of their energy.

#include "06_world/game_world/trial/world_measures.hpp"
#include "07_constraints/taut/trial/taut_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [taut_run]
/// How far [m] the anchors of ball joints are apart at most.
inline double largest_gap(const GameWorld& world, const BallJoints& joints)
{
  double gap = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const BallJoint& joint = joints[i];
    const RigidBody& a = world.bodies()[static_cast<std::size_t>(joint.a)];
    const RigidBody& b = world.bodies()[static_cast<std::size_t>(joint.b)];
    gap = std::max(gap, anchors_of(a, b, joint.anchor_a, joint.anchor_b).error.norm());
  }
  return gap;
}

/// What has come of a scene.
struct TautRun
{
  double gap = 0;  ///< [m], the largest one at any time
  double left = 1; ///< [1], of the energy of the swing, in the end
  double most = 1; ///< [1], the same at its largest
};

/// Runs a chain for a time [s]; energies are counted from where it hangs straight down. It stops
/// where anything is no longer finite, with infinite numbers.
inline TautRun run_chain(GameWorld& world, double seconds)
{
  const Vector3<double> hook = world.bodies()[0].motion.center;
  double lowest = 0;
  for (const RigidBody& body : world.bodies())
  {
    const double below = (body.motion.center - hook).norm();
    lowest += is_fixed(body) ? 0 : 9.81 / body.inverse_mass * (hook.y() - below);
  }
  const double start = energy(world) - lowest;
  TautRun run;
  for (int i = 0; i < seconds * 60; ++i)
  {
    world.step();
    run.gap = std::max(run.gap, largest_gap(world, world.constraints<BallJoints>(0)));
    run.left = (energy(world) - lowest) / start;
    run.most = std::max(run.most, run.left);
    if (!(run.gap < 1e6) || !(run.most < 1e6)) // it explodes
    {
      const double infinite = std::numeric_limits<double>::infinity();
      return {infinite, infinite, infinite};
    }
  }
  return run;
}

/// By how much [m] a chain is too long 10 s after it was let go, hanging.
inline double stretch_of(const TrialChain& chain, const WorldSolver& by = directly())
{
  GameWorld world = world_of(chain, by);
  const double before = world.bodies().back().motion.center.y();
  for (int i = 0; i < 600; ++i)
  {
    world.step();
  }
  return before - world.bodies().back().motion.center.y();
}

/// By how much [m] the sag of a bridge is off the closed form, 15 s after its load was put on.
inline double bridge_error(const HangingBridge& bridge, const WorldSolver& by = directly())
{
  GameWorld world = world_of(bridge, by);
  for (int i = 0; i < 900; ++i)
  {
    world.step();
  }
  const RigidBody& load = world.bodies().back();
  return std::abs(20 - load.motion.center.y() - 0.25 - sag_of(bridge));
}

/// How far [m] the end of welded beams has come down after 5 s.
inline double droop_of_beams(int beams, const WorldSolver& by = directly())
{
  GameWorld world = cantilever(beams, by);
  for (int i = 0; i < 300; ++i)
  {
    world.step();
  }
  return std::abs(5 - world.bodies().back().motion.center.y());
}
// [taut_run]

} // namespace cookbook
