#pragma once

/// \file
/// \brief Bodies that turn so far in a small step that what pushed them before no longer fits.

#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace cookbook
{

// [warm_starting]
/// A box that turns by more than this [rad] feels pushes otherwise afterwards.
inline constexpr double max_warm_turn = 0.05;
/// So does a slender one, if its largest moment over its least, times the square of its turn, is
/// more than this: a needle that is pushed at its end spins about itself once it no longer lies
/// along the arm of that push.
inline constexpr double max_warm_moment = 0.025;

/// Whether a box turns in a time [s] so far that pushes feel another inertia afterwards.
inline bool turns_too_far(const RigidBody& body, double time)
{
  const double squared = time * time * body.motion.angular_velocity.squaredNorm();
  return !body.is_sphere &&
         (squared > max_warm_turn * max_warm_turn ||
          squared * body.moments.maxCoeff() > max_warm_moment * body.moments.minCoeff());
}

/// Whether any box of an island does.
inline bool any_turns_too_far(IslandView world, const Island& island, double time)
{
  return std::any_of(
      island.bodies.begin(), island.bodies.end(),
      [&](int i) { return turns_too_far(world.bodies[index_of(i)], time); });
}

/// A body that turns noticeably, and its energy [J] before it is pushed again as it was.
struct TurningBody
{
  int number;
  double energy;
};

/// Adds a body by its number if it does so in a time [s].
inline void
add_turning(int number, const RigidBody& body, double time, std::vector<TurningBody>& turning)
{
  if (turns_too_far(body, time))
  {
    turning.push_back({number, kinetic_energy(body)});
  }
}

/// Takes back what the points of a body were given at the start of a small step, and forgets it.
inline void discard_warm_start(std::span<IslandPoint> points, const RigidBody& body)
{
  for (IslandPoint& point : points)
  {
    if (point.a == &body || point.b == &body)
    {
      apply_impulse<double>(*point.a, *point.b, point.arms, -contact_impulse(point));
      point.impulse = 0;
      point.friction.setZero();
    }
  }
}

/// Gives points what the step before has ended with. A body that turns noticeably is pushed at arms
/// where it no longer is: where that would give it energy, its points start from nothing.
inline void
warm_start(IslandView world, const Island& island, double substep, std::span<IslandPoint> points)
{
  std::vector<TurningBody> turning;
  for (const int i : island.bodies)
  {
    add_turning(i, world.bodies[index_of(i)], substep, turning);
  }
  for (const IslandPoint& point : points)
  {
    warm_start(point);
  }
  for (const TurningBody& one : turning)
  {
    const RigidBody& body = world.bodies[index_of(one.number)];
    if (kinetic_energy(body) > one.energy)
    {
      discard_warm_start(points, body);
    }
  }
}
// [warm_starting]

} // namespace cookbook
