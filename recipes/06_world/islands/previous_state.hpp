#pragma once

/// \file
/// \brief How a body was before a step: as little as it takes to have it back.

#include "06_world/contacts/rigid_body.hpp"

namespace cookbook
{

// [previous_state]
/// What a step changes of a body.
struct PreviousState
{
  Motion<double> motion;
  Quaternion<double> orientation; ///< unit, body to world
};

/// How a body is now.
inline PreviousState state_of(const RigidBody& body)
{
  return {body.motion, body.orientation};
}

/// How a body of a scene starts; its orientation is unit.
inline PreviousState start_state(const SceneBody& body)
{
  return {{body.position, body.velocity, body.angular_velocity}, body.orientation};
}

/// Has a body of a scene start as it is now.
inline void set_start_state(SceneBody& start, const RigidBody& now)
{
  start.position = now.motion.center;
  start.velocity = now.motion.velocity;
  start.angular_velocity = now.motion.angular_velocity;
  start.orientation = now.orientation;
}

/// A body as it was then.
inline RigidBody with_state(RigidBody body, const PreviousState& then)
{
  body.motion = then.motion;
  body.orientation = body.lagged_orientation = then.orientation;
  update_axes(body);
  return body;
}
// [previous_state]

} // namespace cookbook
