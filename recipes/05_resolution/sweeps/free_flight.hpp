#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity, forces and spin.

#include "05_resolution/contacts/rigid_body.hpp"

namespace cookbook
{

// [fly]
/// A body after gravity and the forces of a step alone have moved it for a time [s]: exactly along
/// its parabola.
inline RigidBody flown(RigidBody body, const Vector3<double>& gravity, double time)
{
  body.motion.center += time * (body.motion.velocity + time / 2 * pull_on(body, gravity));
  pull(body, gravity, time);
  spin(body, time);
  return body;
}
// [fly]

/// Whether anything but gravity and forces has changed how a body moves, since it was at the start
/// of a step [s].
inline bool was_pushed(
    const RigidBody& now, const RigidBody& start, const Vector3<double>& gravity, double step)
{
  const auto differs = [](const Vector3<double>& a, const Vector3<double>& b)
  { return (a - b).norm() > 1e-9 * b.norm(); };
  const Motion<double> alone = after_pull(start, gravity, step);
  return differs(now.motion.velocity, alone.velocity) ||
         differs(now.motion.angular_velocity, alone.angular_velocity);
}

} // namespace cookbook
