#pragma once

/// \file
/// \brief A pendulum on a ball joint, and the closed form of its period.

#include "05_resolution/integrators/trial/pendulum.hpp"
#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/game_world/solvers.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cookbook
{

// [pendulum]
/// How a pendulum swings: a ball of 2 kg and 10 cm, its centre 1 m below the joint.
struct PendulumScene
{
  std::string solver = "direct";
  int rate = 240;         ///< [1/s], steps
  double amplitude = 0.5; ///< [rad]
  double duration = 20;   ///< [s]
};

/// What has come of it.
struct Swing
{
  double period;      ///< [s], mean of all swings
  double right;       ///< [s], by the closed form
  double apart;       ///< [m], how far the anchors were apart at most
  double least, most; ///< [J], energy beyond that of the start
  double swings_up;   ///< [J], the energy of the swing
};

/// The period [s] of a body with a moment about its axis of squared radius [m²] times its mass,
/// whose centre is at a distance [m] from it: that of a point on a rod of squared radius over
/// distance; R31.
inline double period_of(double squared_radius, double distance, double gravity, double amplitude)
{
  return pendulum_period(Pendulum<double>{gravity, squared_radius / distance}, amplitude);
}

/// Has the pendulum swing.
inline Swing swing_of(const PendulumScene& how)
{
  const double radius = 0.1, mass = 2, gravity = 9.81;
  Scene scene;
  scene.step = 1.0 / how.rate;
  scene.bodies = {
      {.name = "hook", .shape = SphereShape{0.05}, .position = {0, 5, 0}},
      {.name = "bob",
       .shape = SphereShape{radius},
       .mass = mass,
       .position = {std::sin(how.amplitude), 5 - std::cos(how.amplitude), 0}}};
  GameWorld world(scene, solver_named(how.solver));
  BallJoints joints;
  joints.add(ball_joint_at(world, 0, 1, {0, 5, 0}));
  world.add(joints);
  const RigidBody& bob = world.body(1);
  const auto energy = [&] { return kinetic_energy(bob) + mass * gravity * bob.motion.center.y(); };
  const double start = energy();
  Swing swing{0, period_of(1 + 0.4 * radius * radius, 1, gravity, how.amplitude),
              0, 0,
              0, mass * gravity * (1 - std::cos(how.amplitude))};
  double first = -1, last = -1, before = bob.motion.center.x();
  int crossings = 0;
  while (world.time() < how.duration)
  {
    world.step();
    const double x = bob.motion.center.x();
    if ((x > 0) != (before > 0))
    {
      last = world.time() - scene.step * x / (x - before);
      first = first < 0 ? last : first;
      ++crossings;
    }
    before = x;
    const BallJoint& joint = joints[0];
    const Anchors anchors = anchors_of(world.body(0), bob, joint.anchor_a, joint.anchor_b);
    swing.apart = std::max(swing.apart, anchors.error.norm());
    swing.least = std::min(swing.least, energy() - start);
    swing.most = std::max(swing.most, energy() - start);
  }
  swing.period = 2 * (last - first) / (crossings - 1);
  return swing;
}
// [pendulum]

} // namespace cookbook
