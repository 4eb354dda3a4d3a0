#pragma once

/// \file
/// \brief How a body of a world moves on with its velocities.

#include "01_math/turning/rotation_by.hpp"
#include "05_resolution/damping/damping.hpp"
#include "05_resolution/spinning_bodies/mean_spin.hpp"
#include "05_resolution/spinning_bodies/spin_with_energy.hpp"
#include "06_world/contacts/rigid_body.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [integrate_body]
/// How a body is turned once it has turned about a vector, world, by its length [rad].
template <class AnyBody>
Quaternion<double> turned_by(const AnyBody& body, const Vector3<double>& turn)
{
  return (rotation_by<double>(turn) * body.orientation).normalized();
}

/// Turns a body about the direction of a vector by its length [rad], world.
inline void turn_by(RigidBody& body, const Vector3<double>& turn)
{
  body.orientation = turned_by(body, turn);
  update_axes(body);
}

/// The largest turn [rad] taken in one go, and into how many pieces a larger one is cut at most.
inline constexpr double max_turn_step = 0.5;
inline constexpr double max_turn_steps = 100;

/// Whether a body's moments are all the same, as a ball's and a cube's: it spins on as it does.
inline bool has_equal_moments(const RigidBody& body)
{
  return (body.moments.array() == body.moments.x()).all();
}

/// How a body is turned, and how it spins.
inline Spinning<double> rotation_of(const RigidBody& body)
{
  return {body.orientation, body.motion.angular_velocity};
}

/// Turns a body, and has it spin, like another.
inline void set_rotation(const Spinning<double>& from, RigidBody& to)
{
  to.orientation = from.orientation;
  to.motion.angular_velocity = from.angular_velocity;
}

/// Turns a body freely for a time [s]: its angular momentum and its energy stay as they are; R24.
/// Its matrices are left for update_axes().
///
/// Where even the pieces of a turn are too large, it loses some spin, and never gains energy.
inline void integrate_free_rotation(RigidBody& body, double time)
{
  if (has_equal_moments(body))
  {
    body.orientation = turned_by(body, time * body.motion.angular_velocity);
    return;
  }
  const double turn = time * body.motion.angular_velocity.norm();
  const bool too_fast = turn > max_turn_step * max_turn_steps;
  const auto energy = [&]
  {
    update_axes(body);
    return kinetic_energy(body);
  };
  const double before = too_fast ? energy() : 0;
  const double pieces = std::clamp(std::ceil(turn / max_turn_step), 1.0, max_turn_steps);
  Spinning<double> spun = rotation_of(body);
  for (double piece = 0; piece < pieces; ++piece)
  {
    spun = turned_with_energy<double>(spun, body.moments, time / pieces);
  }
  set_rotation(spun, body);
  if (too_fast && energy() > before)
  {
    body.motion.angular_velocity *= std::sqrt(before / kinetic_energy(body));
  }
}

/// Turns a body freely for a time [s], and its matrices with it.
inline void rotate_freely(RigidBody& body, double time)
{
  integrate_free_rotation(body, time);
  update_axes(body);
}

/// Whether a body turns little in a time [s], for turned_about_mean().
inline bool turns_little(const RigidBody& body, double time)
{
  return turns_little<double>(body.moments, time * body.motion.angular_velocity.norm());
}

/// Turns a body that is touched for a time [s]; its matrices are left for update_axes().
inline void integrate_rotation(RigidBody& body, double time)
{
  if (has_equal_moments(body) || !turns_little(body, time))
  {
    integrate_free_rotation(body, time);
  }
  else
  {
    set_rotation(turned_about_mean<double>(rotation_of(body), body.moments, time), body);
  }
}

/// Damps a body's velocity and angular velocity for a time [s], at the rates of a scene; R32. A
/// kinematic one keeps its own.
inline void apply_damping(RigidBody& body, const SceneBody& of, double time)
{
  if (!is_fixed(body) && (of.damping > 0 || of.angular_damping > 0))
  {
    body.motion.velocity *= damping_factor(of.damping, time);
    body.motion.angular_velocity *= damping_factor(of.angular_damping, time);
  }
}

/// Moves a body that is touched with its velocities for a time [s], and its matrices with it.
inline void integrate_position(RigidBody& body, double time)
{
  body.motion.center += time * body.motion.velocity;
  integrate_rotation(body, time);
  update_axes(body);
}
// [integrate_body]

} // namespace cookbook
