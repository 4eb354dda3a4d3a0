#pragma once

/// \file
/// \brief How surfaces that stick would drift apart in a step, as their bodies turn.

#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/soft_steps/lagged_anchors.hpp"

namespace cookbook
{

// [stick_drift]
/// A body that turns by more than this [rad] in a step is not held on what turns with it: several
/// points that stick would ask for more than one body can do, and strain it.
inline constexpr double max_stick_turn = 0.05;

/// Whether what a body turns with goes round in a step [s]: not where it turns so slowly that its
/// arms stay as they were, nor where it turns too far.
inline bool carries_round(const RigidBody& body, double step)
{
  const double speed = body.motion.angular_velocity.norm();
  return speed > max_lagging_spin && step * speed <= max_stick_turn;
}

/// The centripetal acceleration [m/s²] of a body's point at an arm [m], where the body carries it
/// round.
inline Vector3<double>
centripetal_acceleration(const RigidBody& body, const Vector3<double>& arm, double step)
{
  return carries_round(body, step)
             ? cookbook::centripetal_acceleration(body.motion.angular_velocity, arm)
             : Vector3<double>(0, 0, 0);
}

/// How fast [m/s²] the velocity with which B's surface slides over A's must grow, so that the point
/// at which they stick stays one in a step [s], although arms are those of its beginning: R6.
///
/// A step goes straight on where the point of a body that turns goes round: after a time t it is
/// off by a t² / 2. Two points that start with equal velocities so drift apart, on a turntable
/// outwards by ω² r t² / 2 in each step, unless they slide by the difference of their accelerations
/// a, times the time since the arms were taken. Not where a sphere rolls, or a box on one: their
/// point of contact is another one in each step.
inline Vector3<double> stick_drift(
    const RigidBody& a, const RigidBody& b, const Vector3<double>& normal, const Arms<double>& arms,
    double step)
{
  if (a.is_sphere || b.is_sphere || !(carries_round(a, step) || carries_round(b, step)))
  {
    return Vector3<double>::Zero();
  }
  return along_surface<double>(
      centripetal_acceleration(a, arms.a, step) - centripetal_acceleration(b, arms.b, step),
      normal);
}

/// The same of a contact point, along its surface.
inline Vector2<double> drift_of(
    const ContactConstraint<double>& point, const RigidBody& a, const RigidBody& b, double step)
{
  return point.surface.along(stick_drift(a, b, point.normal, point.arms, step));
}
// [stick_drift]

} // namespace cookbook
