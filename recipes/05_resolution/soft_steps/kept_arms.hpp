#pragma once

/// \file
/// \brief Arms that stay as they are while a body hardly turns, so that soft towers do not bend.

#include "05_resolution/islands/island_points.hpp"

namespace cookbook
{

// [kept_arms]
/// A body that turns by more than this [rad] in a step has its arms taken anew.
inline constexpr double slow_turn = 0.001;

/// Takes the arms at which a body is pushed as it is turned now: if it does not turn slowly in a
/// step [s], or has turned by more than a limit [rad] since they were taken.
inline void take_arms(RigidBody& body, double limit, double step)
{
  const Quaternion<double> since = body.orientation * body.arms_at.conjugate();
  const bool slow = step * body.motion.angular_velocity.norm() <= slow_turn;
  if (!slow || 2 * since.vec().norm() > limit)
  {
    body.arms_at = body.orientation;
  }
}

/// The same of all bodies of an island.
inline void take_arms(IslandView world, const Island& island, double limit, double step)
{
  for (const int i : island.bodies)
  {
    take_arms(world.bodies[place_of(i)], limit, step);
  }
}

/// The arms [m], world, of a contact point as its bodies were turned when they were taken; those of
/// a ball do not turn with it.
inline Arms<double> kept_arms(const RigidBody& a, const RigidBody& b, const WorldPoint& point)
{
  const auto arm = [](const RigidBody& body, const Vector3<double>& on) -> Vector3<double>
  { return body.round ? on : body.arms_at * on; };
  return {arm(a, point.on_a), arm(b, point.on_b)};
}
// [kept_arms]

} // namespace cookbook
