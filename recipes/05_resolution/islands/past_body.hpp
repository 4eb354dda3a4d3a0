#pragma once

/// \file
/// \brief How a body was before a step: as little as it takes to have it back.

#include "05_resolution/contacts/rigid_body.hpp"

namespace cookbook
{

// [past_body]
/// What a step changes of a body, and the forces that it forgets.
struct PastBody
{
  Motion<double> motion;
  Quaternion<double> orientation;       ///< unit, body to world
  Vector3<double> acceleration;         ///< [m/s²], world, by the forces of that step
  Vector3<double> angular_acceleration; ///< [rad/s²], world, by the same
};

/// How a body is now.
inline PastBody past_of(const RigidBody& body)
{
  return {body.motion, body.orientation, body.acceleration, body.angular_acceleration};
}

/// A body as it was then.
inline RigidBody as_it_was(RigidBody body, const PastBody& then)
{
  body.motion = then.motion;
  body.orientation = body.arms_at = then.orientation;
  body.acceleration = then.acceleration;
  body.angular_acceleration = then.angular_acceleration;
  update_axes(body);
  return body;
}
// [past_body]

} // namespace cookbook
