#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity and spin.

#include "05_resolution/contacts/rigid_body.hpp"
#include "05_resolution/spinning_bodies/spin_with_energy.hpp"

namespace cookbook
{

// [fly]
/// A body after it has fallen and spun freely for a time [s]: exactly along its parabola.
inline RigidBody flown(RigidBody body, const Vector3<double>& gravity, double time)
{
  body.position += time * (body.velocity + time / 2 * gravity);
  body.velocity += time * gravity;
  const Spinning<double> spun =
      turned_with_energy<double>({body.orientation, body.angular_velocity}, body.moments, time);
  body.orientation = spun.orientation;
  body.angular_velocity = spun.angular_velocity;
  update_axes(body);
  return body;
}
// [fly]

/// Whether a body, since it was at the start of a step [s], has been given anything but gravity.
inline bool was_pushed(
    const RigidBody& now, const RigidBody& start, const Vector3<double>& gravity, double step)
{
  const Vector3<double> fallen = start.velocity + step * gravity;
  const double turned = (now.angular_velocity - start.angular_velocity).norm();
  return (now.velocity - fallen).norm() > 1e-9 * fallen.norm() ||
         turned > 1e-9 * start.angular_velocity.norm();
}

} // namespace cookbook
