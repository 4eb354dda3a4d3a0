#pragma once

/// \file
/// \brief How a body was before a step: as little as it takes to have it back.

#include "06_world/contacts/rigid_body.hpp"

namespace cookbook
{

// [past_body]
/// What a step changes of a body.
struct PastBody
{
  Motion<double> motion;
  Quaternion<double> orientation; ///< unit, body to world
};

/// How a body is now.
inline PastBody past_of(const RigidBody& body)
{
  return {body.motion, body.orientation};
}

/// How a body of a scene starts; its orientation is unit.
inline PastBody start_of(const SceneBody& body)
{
  return {{body.position, body.velocity, body.angular_velocity}, body.orientation};
}

/// Has a body of a scene start as it is now.
inline void set_start(SceneBody& start, const RigidBody& now)
{
  start.position = now.motion.center;
  start.velocity = now.motion.velocity;
  start.angular_velocity = now.motion.angular_velocity;
  start.orientation = now.orientation;
}

/// A body as it was then.
inline RigidBody as_it_was(RigidBody body, const PastBody& then)
{
  body.motion = then.motion;
  body.orientation = body.arms_at = then.orientation;
  update_axes(body);
  return body;
}
// [past_body]

} // namespace cookbook
