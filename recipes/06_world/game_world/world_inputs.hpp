#pragma once

/// \file
/// \brief What a game does to the bodies of a world between two steps: impulses, forces,
/// velocities.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "06_world/game_world/game_world.hpp"

namespace cookbook
{

// [world_inputs]
/// Gives a body an impulse [N s], world, at a point [m], world; it wakes. A fixed one stays as it
/// is. std::out_of_range if there is no such body; InvalidShape, and nothing changes, if a number
/// is not finite.
inline void apply_impulse(
    GameWorld& world, BodyId body, const Vector3<double>& impulse, const Vector3<double>& point)
{
  check_finite("impulse", impulse);
  check_finite("point", point);
  Body<double> pushed = world.body(body);
  apply_impulse<double>(pushed, point - pushed.motion.center, impulse);
  world.set_velocity(body, pushed.motion.velocity, pushed.motion.angular_velocity);
}

/// The same at a body's centre, so that it does not turn.
inline void apply_impulse(GameWorld& world, BodyId body, const Vector3<double>& impulse)
{
  apply_impulse(world, body, impulse, world.body(body).motion.center);
}

/// Has a force [N], world, act on a body at a point [m], world, all through the next step.
inline void apply_force(
    GameWorld& world, BodyId body, const Vector3<double>& force, const Vector3<double>& point)
{
  check_finite("force", force);
  check_finite("point", point);
  const RigidBody& pulled = world.body(body);
  const Vector3<double> torque = (point - pulled.motion.center).cross(force);
  world.accelerate(body, pulled.inverse_mass * force, pulled.inverse_inertia * torque);
}

/// The same at a body's centre.
inline void apply_force(GameWorld& world, BodyId body, const Vector3<double>& force)
{
  apply_force(world, body, force, world.body(body).motion.center);
}

/// Has a torque [N m], world, act on a body all through the next step.
inline void apply_torque(GameWorld& world, BodyId body, const Vector3<double>& torque)
{
  check_finite("torque", torque);
  world.accelerate(body, {0, 0, 0}, world.body(body).inverse_inertia * torque);
}
// [world_inputs]

} // namespace cookbook
