#pragma once

/// \file
/// \brief Shifts bodies of a world at a contact point: as an impulse does velocities, but
/// positions.

#include "01_math/turning/turn_between.hpp"
#include "06_world/islands/island_points.hpp"

namespace cookbook
{

// [position_impulse]
/// Turns a body by a small rotation vector [rad], world.
///
/// The half of a small angle stands for its sine: an angle of 0.1 comes out as 0.0999.
inline void rotate(RigidBody& body, const Vector3<double>& rotation)
{
  const Vector3<double> half = rotation / 2;
  const Quaternion<double> by(1, half.x(), half.y(), half.z());
  body.orientation = (by * body.orientation).normalized();
  update_axes(body);
}

/// Gives a body the velocities that lead from where it was to where it is, in a time [s].
inline void derive_velocities(const PreviousState& before, RigidBody& now, double time)
{
  now.motion.velocity = (now.motion.center - before.motion.center) / time;
  now.motion.angular_velocity = turn_between<double>(before.orientation, now.orientation) / time;
}

/// Shifts a body by a push [kg m], world, at an arm [m], world, from its centre of mass.
inline void
apply_position_impulse(RigidBody& body, const Vector3<double>& arm, const Vector3<double>& push)
{
  if (!is_fixed(body))
  {
    body.motion.center += body.inverse_mass * push;
    rotate(body, body.inverse_inertia * arm.cross(push));
  }
}

/// The arms [m], world, of a contact point as its bodies are turned now.
inline Arms<double> current_arms(const IslandPoint& point)
{
  return arms_of(*point.a, *point.b, *point.cached);
}

/// The inverse mass [1/kg] at a point along a unit direction, as the bodies are now; R1.
inline double current_inverse_mass(const IslandPoint& point, const Vector3<double>& direction)
{
  return inverse_mass_at<double>(*point.a, *point.b, direction, current_arms(point));
}

/// Shifts B by a push [kg m], world, at a point, and A by its opposite.
inline void apply_position_impulse(IslandPoint& point, const Vector3<double>& push)
{
  const Arms<double> arms = current_arms(point);
  apply_position_impulse(*point.a, arms.a, -push);
  apply_position_impulse(*point.b, arms.b, push);
}
// [position_impulse]

} // namespace cookbook
