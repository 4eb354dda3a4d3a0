#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity and spin.

#include "05_resolution/contacts/rigid_body.hpp"

namespace cookbook
{

// [fly]
/// A body after it has fallen and spun freely for a time [s]: exactly along its parabola.
inline RigidBody flown(RigidBody body, const Vector3<double>& gravity, double time)
{
  body.motion.center += time * (body.motion.velocity + time / 2 * gravity);
  body.motion.velocity += time * gravity;
  spin(body, time);
  return body;
}
// [fly]

/// Whether a body, since it was at the start of a step [s], has been given anything but gravity.
inline bool was_pushed(
    const RigidBody& now, const RigidBody& start, const Vector3<double>& gravity, double step)
{
  const Vector3<double> fallen = start.motion.velocity + step * gravity;
  const double turned = (now.motion.angular_velocity - start.motion.angular_velocity).norm();
  return (now.motion.velocity - fallen).norm() > 1e-9 * fallen.norm() ||
         turned > 1e-9 * start.motion.angular_velocity.norm();
}

} // namespace cookbook
