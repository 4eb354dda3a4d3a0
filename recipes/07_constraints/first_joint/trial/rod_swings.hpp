#pragma once

/// \file
/// \brief Pendulums on a rod and on a joint: their periods, energies, and what they should be.

#include "05_resolution/integrators/trial/pendulum.hpp"
#include "07_constraints/first_joint/first_joint.hpp"
#include "07_constraints/first_joint/joined_step.hpp"
#include "07_constraints/first_joint/small_joint.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace cookbook
{

/// A pendulum, and how it is stepped.
struct PendulumSetup
{
  double amplitude = 0.5; ///< [rad]
  int rate = 60;          ///< [1/s], steps
  double duration = 60;   ///< [s]
};

/// What has come of it.
struct PendulumRun
{
  double period;                       ///< [s], mean of all swings
  double right;                        ///< [s], by the elliptic integral; R31
  double left;                         ///< [1], energy of the swing in the last 3 s, of what it was
  double apart;                        ///< [m], how far the constraint was off at most
  std::vector<Eigen::Vector2d> energy; ///< [s], and the mean over a second of that fraction
};

/// What a pendulum shows after a step.
struct PendulumLook
{
  double aside;  ///< [m], to the side
  double energy; ///< [1], fraction of the energy of the swing, 1 at the start
  double apart;  ///< [m], how far the constraint is off
};

/// Has a pendulum swing; `step` makes a step and looks.
inline PendulumRun
swing_by(const PendulumSetup& scene, double right, const std::function<PendulumLook()>& step)
{
  PendulumRun run{0, right, 0, 0, {{0, 1}}};
  double first = -1, last = -1, before = std::sin(scene.amplitude), second = 0;
  int crossings = 0;
  const int steps = static_cast<int>(scene.duration * scene.rate);
  for (int i = 1; i <= steps; ++i)
  {
    const PendulumLook look = step();
    if ((look.aside > 0) != (before > 0))
    {
      last = (i - look.aside / (look.aside - before)) / scene.rate;
      first = first < 0 ? last : first;
      ++crossings;
    }
    before = look.aside;
    run.apart = std::max(run.apart, std::abs(look.apart));
    run.left += i > steps - 3 * scene.rate ? look.energy / (3 * scene.rate) : 0;
    second += look.energy / scene.rate;
    if (i % scene.rate == 0)
    {
      run.energy.push_back({static_cast<double>(i) / scene.rate - 0.5, second});
      second = 0;
    }
  }
  run.period = 2 * (last - first) / (crossings - 1);
  return run;
}

/// The gravity [m/s²] of these pendulums.
inline constexpr double pendulum_gravity = 9.81;

/// A point on a rod of 1 m.
inline PendulumRun rod_swing(const PendulumSetup& scene, const Rod<double>& rod)
{
  const double up = pendulum_gravity * (1 - std::cos(scene.amplitude)), step = 1.0 / scene.rate;
  const Vector3<double> start(std::sin(scene.amplitude), -std::cos(scene.amplitude), 0);
  PhasePoint<Vector3<double>> at{start, Vector3<double>::Zero()};
  const double right =
      pendulum_period(Pendulum<double>{pendulum_gravity, rod.length}, scene.amplitude);
  return swing_by(
      scene, right,
      [&]() -> PendulumLook
      {
        at = rod_step<double>(at, rod, {0, -pendulum_gravity, 0}, step);
        const double height = at.position.y() - start.y();
        const double energy = at.velocity.squaredNorm() / 2 + pendulum_gravity * height;
        return {at.position.x(), 1 + energy / up, at.position.norm() - rod.length};
      });
}

/// A plank of 60 cm and 2 kg in the small world, on a joint 50 cm above its centre.
inline PendulumRun plank_swing(const PendulumSetup& scene)
{
  namespace small = small_world;
  const double half = scene.amplitude / 2, arm = 0.5, mass = 2, weight = mass * pendulum_gravity;
  small::World world;
  add(world, small::box({0, 5, 0}, {0.05, 0.05, 0.05}, 0));
  add(world, small::box({0, 5 - arm, 0}, {0.1, 0.3, 0.05}, mass));
  small::RigidBody& plank = world.bodies[1];
  const double sine = std::sin(scene.amplitude), cosine = std::cos(scene.amplitude);
  plank.motion.center = {arm * sine, 5 - arm * cosine, 0};
  set_orientation(plank, {std::cos(half), 0, 0, std::sin(half)});
  std::vector<small::BallJoint> joints{small::ball_joint_at(world, 0, 1, {0, 5, 0})};
  const double inertia = plank.moments.z() + mass * arm * arm;
  const Pendulum<double> same{pendulum_gravity, inertia / (mass * arm)};
  const double start = plank.motion.center.y(), up = weight * arm * (1 - cosine);
  return swing_by(
      scene, pendulum_period(same, scene.amplitude),
      [&]() -> PendulumLook
      {
        small::step_joined(world, joints, 1.0 / scene.rate);
        const auto& [center, velocity, spin] = plank.motion;
        const double turns = plank.moments.z() * spin.z() * spin.z() / 2;
        const double energy =
            mass / 2 * velocity.squaredNorm() + turns + weight * (center.y() - start);
        const Vector3<double> top = center + plank.orientation * joints[0].anchor_b;
        return {center.x(), 1 + energy / up, (top - Vector3<double>(0, 5, 0)).norm()};
      });
}

/// How far [m] the anchors of a chain of links of 1 m are apart at most within ten seconds, or
/// until they are a metre apart; the lowest has a mass [kg] of its own, and is nudged by half a
/// metre a second.
inline double chain_apart(
    int links, double lowest, Softness<double> (*softness)(double) = small_world::joint_softness)
{
  namespace small = small_world;
  small::World world;
  std::vector<small::BallJoint> joints;
  add(world, small::box({0, 20, 0}, {0.1, 0.1, 0.1}, 0));
  for (int i = 0; i < links; ++i)
  {
    const auto upper = static_cast<std::size_t>(i);
    add(world, small::box({0, 19.5 - i, 0}, {0.1, 0.5, 0.1}, i == links - 1 ? lowest : 1));
    joints.push_back(small::ball_joint_at(world, upper, upper + 1, {0, 20.0 - i, 0}));
  }
  world.bodies.back().motion.velocity.x() = 0.5;
  double most = 0;
  for (int frame = 0; frame < 600 && most < 1; ++frame)
  {
    small::step_joined(world, joints, 1.0 / 60, softness);
    for (small::BallJoint joint : joints)
    {
      joint.impulse.setZero();
      prepare_joint(world, joint, 1.0 / 240);
      most = std::max(most, joint.error.norm());
    }
  }
  return most;
}

} // namespace cookbook
