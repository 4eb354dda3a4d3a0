#pragma once

/// \file
/// \brief A reader's scene by each solver: what is right is known of its laws alone.

#include "06_world/game_world/trial/joint_opening.hpp"
#include "07_constraints/joint_trial/trial/joint_trial.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace cookbook
{

// [own_scene]
/// What a run has kept of the laws.
struct LawsKept
{
  JointOpening open{};     ///< the largest at any time
  double worst = 0;        ///< [s], when joints were farthest open
  double energy_start = 0; ///< [J]
  double energy_end = 0;   ///< [J]
  double energy_most = 0;  ///< [J], at any time
  double linear = 0;       ///< [kg m/s], by which the momentum is off M g t at most
  double angular = 0;      ///< [kg m²/s], the same about the centre of mass, which is to stay
  bool held = false;       ///< whether something held or touched it that is not dynamic
};

/// The momenta of all bodies, the angular one about their centre of mass.
struct CentralMomenta
{
  Vector3<double> linear, angular;
  double mass;
};
inline CentralMomenta central_momenta(std::span<const RigidBody> bodies)
{
  double mass = 0;
  Vector3<double> center(0, 0, 0);
  for (const RigidBody& body : bodies)
  {
    mass += is_fixed(body) ? 0 : 1 / body.inverse_mass;
    center += is_fixed(body) ? Vector3<double>(0, 0, 0)
                             : Vector3<double>(body.motion.center / body.inverse_mass);
  }
  const Vector3<double> linear = momentum(bodies);
  return {linear, angular_momentum(bodies) - (center / mass).cross(linear), mass};
}

/// Whether joints or contacts hold a body that is not dynamic: momenta go there.
inline bool is_held(GameWorld& world)
{
  bool held = false;
  const auto look_at = [&](int a, int b) {
    held = held || is_fixed(world.bodies()[index_of(a)]) || is_fixed(world.bodies()[index_of(b)]);
  };
  for (std::size_t place = 0; place < world.constraint_sets(); ++place)
  {
    world.constraint_set(place).each_pair([&](const ConstraintPair& pair)
                                          { look_at(pair.a, pair.b); });
  }
  for (const WorldContact& contact : world.contacts())
  {
    for (const WorldPoint& point : contact.points)
    {
      if (point.impulse > 0)
      {
        look_at(contact.a, contact.b);
      }
    }
  }
  return held;
}

/// Runs a scene for its duration; std::logic_error where the method cannot.
inline LawsKept laws_kept(const JointRun& run, Scene scene)
{
  const int steps = run.method.steps(run.count);
  const double frame = scene.step;
  const long frames = std::lround(scene.duration / frame);
  scene.step /= steps;
  GameWorld world(scene, run.method.solver(run.count));
  const CentralMomenta before = central_momenta(world.bodies());
  LawsKept kept;
  kept.energy_start = kept.energy_most = energy(world);
  for (long step = 1; step <= frames * steps; ++step)
  {
    kept.held = kept.held || is_held(world);
    world.step();
    const JointOpening open = joint_opening(world);
    kept.worst = open.length > kept.open.length ? world.time() : kept.worst;
    kept.open = {std::max(kept.open.length, open.length), std::max(kept.open.angle, open.angle)};
    kept.energy_end = energy(world);
    kept.energy_most = std::max(kept.energy_most, kept.energy_end);
    const CentralMomenta now = central_momenta(world.bodies());
    const Vector3<double> fallen = world.time() * before.mass * scene.gravity;
    kept.linear = std::max(kept.linear, (now.linear - before.linear - fallen).norm());
    kept.angular = std::max(kept.angular, (now.angular - before.angular).norm());
  }
  kept.held = kept.held || is_held(world);
  return kept;
}
// [own_scene]

} // namespace cookbook
