#pragma once

/// \file
/// \brief What is measured of worlds with joints: how far these come apart, and what is left
/// of energy.

#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/joint_trial/trial/joint_methods.hpp"
#include "07_constraints/joint_trial/trial/joint_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace cookbook
{

/// What a method has made of a scene where a joint came apart by more than a link's
/// length.
inline constexpr double joint_fails = std::numeric_limits<double>::infinity();

// [joint_measures]
/// How far [m] the anchors of a world's joints are apart, at most.
inline double most_apart(GameWorld& world)
{
  const BallJoints& joints = world.constraints<BallJoints>(0);
  double most = 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const BallJoint& joint = joints[i];
    const RigidBody& a = world.bodies()[static_cast<std::size_t>(joint.a)];
    const RigidBody& b = world.bodies()[static_cast<std::size_t>(joint.b)];
    most = std::max(most, anchors_of(a, b, joint.anchor_a, joint.anchor_b).error.norm());
  }
  return most;
}

/// The energy [J] of all bodies, from the height of the origin.
inline double trial_energy(const GameWorld& world)
{
  double sum = 0;
  for (const RigidBody& body : world.bodies())
  {
    if (body.inverse_mass > 0)
    {
      sum +=
          kinetic_energy(body) - world.scene().gravity.dot(body.motion.center) / body.inverse_mass;
    }
  }
  return sum;
}

/// Linear [kg m/s] and angular momentum [kg m²/s] of all bodies, one below the other.
inline Vector6 trial_momenta(const GameWorld& world)
{
  Vector6 sum = Vector6::Zero();
  for (const RigidBody& body : world.bodies())
  {
    const Vector3<double> momentum = body.motion.velocity / body.inverse_mass;
    const Vector3<double> spin = body.axes.transpose() * body.motion.angular_velocity;
    sum.head<3>() += momentum;
    sum.tail<3>() += body.motion.center.cross(momentum);
    sum.tail<3>() += body.axes * body.moments.cwiseProduct(spin);
  }
  return sum;
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
    world.step();
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
  const double start = trial_energy(jointed_world(scene, run.method.solver(run.count)));
  double last = start;
  const auto look = [&](GameWorld& world) { last = trial_energy(world); };
  return run_joints(run, scene, frames, look) ? (last - lowest) / (start - lowest) : joint_fails;
}
// [joint_measures]

} // namespace cookbook
