#pragma once

/// \file
/// \brief Corrected positions on the small world's bodies: position-based dynamics, plain.

#include "05_resolution/small_world/step_4.hpp"

#include <algorithm>
#include <vector>

namespace cookbook::small_world::plain_positions
{

using Contact = step_4::Contact;

/// The bodies and the contact points of step 4; only what a step does is another.
struct World : step_4::World
{
};

// [shift]
/// Moves and turns a body by an impulse [N s] at an arm [m] that acts for a time [s]: what it would
/// change the velocity by, times the time.
inline void
shift(RigidBody& body, const Vector3<double>& arm, const Vector3<double>& impulse, double time)
{
  body.motion.center += time * body.inverse_mass * impulse;
  const Vector3<double> turn = time * body.inverse_inertia * arm.cross(impulse);
  set_orientation(body, rotation_by(turn) * body.orientation);
}

/// How far [m] a body's surface has moved at an arm [m] since the body was as it was before.
inline Vector3<double>
displacement(const RigidBody& before, const RigidBody& now, const Vector3<double>& arm)
{
  const Quaternion<double> turn = now.orientation * before.orientation.conjugate();
  return now.motion.center - before.motion.center + turn * arm - arm;
}
// [shift]

// [correct_contact]
/// Overlap [m] that is left, so that surfaces at rest are found to touch in the next step, too.
inline constexpr double slop = 1e-4;

/// The bodies of a world as a substep began.
using Bodies = std::vector<RigidBody>;

/// How far [m] B's surface has moved from A's at a contact point in this substep.
inline Vector3<double>
relative_displacement(const World& world, const Bodies& before, const Contact& contact)
{
  return displacement(before[contact.b], world.bodies[contact.b], contact.arms.b) -
         displacement(before[contact.a], world.bodies[contact.a], contact.arms.a);
}

/// Moves two bodies apart by an impulse [N s] on B that acts for a time [s].
inline void
shift_apart(World& world, const Contact& contact, const Vector3<double>& impulse, double time)
{
  shift(world.bodies[contact.a], contact.arms.a, -impulse, time);
  shift(world.bodies[contact.b], contact.arms.b, impulse, time);
}

/// Takes the overlap at a contact point back, at 1 m/s at most; R15.
inline void correct_overlap(World& world, const Bodies& before, Contact& contact, double time)
{
  const double moved = relative_displacement(world, before, contact).dot(contact.normal);
  const double error = std::max(contact.separation + slop + moved, -1.0 * time);
  const double sum = accumulated_impulse(contact.impulse, -contact.normal_mass * error / time);
  shift_apart(world, contact, (sum - contact.impulse) * contact.normal, time);
  contact.impulse = sum;
}

/// The velocity [m/s] at which B has slipped over A in a substep, with the slip that is left from
/// those before.
inline Vector2<double>
slip_velocity(const World& world, const Bodies& before, const Contact& contact, double time)
{
  const Vector3<double> moved = relative_displacement(world, before, contact);
  return contact.surface.along(moved) / time - contact.friction / contact.sliding.smallest;
}

/// Takes the slip at a contact point back, as far as the friction cone allows; R6.
inline void correct_slip(World& world, const Bodies& before, Contact& contact, double time)
{
  const Vector2<double> impulse = friction_impulse<double>(
      slip_velocity(world, before, contact, time), contact.sliding, {0, 0},
      contact.coefficient * contact.impulse);
  shift_apart(world, contact, contact.surface.in_world(impulse), time);
}

/// Stores the slip that is left after all points were corrected, as the impulse [N s] that would
/// take it back.
inline void store_slip(const World& world, const Bodies& before, Contact& contact, double time)
{
  const Vector2<double> slip = slip_velocity(world, before, contact, time);
  contact.friction = within_cone<double, 2>(
      -contact.sliding.smallest * slip, contact.coefficient * contact.impulse);
}
// [correct_contact]

// [substep]
/// Gives each body the velocity with which it has come from where it was before a time [s].
inline void compute_velocities(World& world, const Bodies& before, double time)
{
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    RigidBody& body = world.bodies[i];
    if (body.inverse_mass > 0)
    {
      const Quaternion<double> turn = body.orientation * before[i].orientation.conjugate();
      body.motion.velocity = (body.motion.center - before[i].motion.center) / time;
      body.motion.angular_velocity = (turn.w() < 0 ? -2 : 2) / time * turn.vec();
    }
  }
}

/// Stops the separating velocity at an active contact point, so that a body which was moved out of
/// an overlap does not fly off.
inline void stop_separating(World& world, Contact& contact)
{
  RigidBody &a = world.bodies[contact.a], &b = world.bodies[contact.b];
  if (contact.impulse > 0)
  {
    const double change = -contact.normal_mass * separating_velocity<double>(a, b, contact);
    apply_impulse<double>(a, b, contact.arms, change * contact.normal);
  }
}

/// Moves a world on by a substep [s].
inline void substep(World& world, double time)
{
  const Bodies before = world.bodies;
  step_4::apply_gravity(world, time);
  for (RigidBody& body : world.bodies)
  {
    integrate_position(body, time);
  }
  for (Contact& contact : world.contacts)
  {
    contact.impulse = 0;
    correct_overlap(world, before, contact, time);
  }
  for (Contact& contact : world.contacts)
  {
    correct_slip(world, before, contact, time);
  }
  compute_velocities(world, before, time);
  for (Contact& contact : world.contacts)
  {
    contact.separation += relative_displacement(world, before, contact).dot(contact.normal);
    store_slip(world, before, contact, time);
    contact.total_impulse += contact.impulse;
    stop_separating(world, contact);
  }
}

/// Moves a world on by a time [s], in twenty substeps.
inline void step(World& world, double time)
{
  check("time", time, 1e-6, 0.1);
  step_4::find_contacts(world);
  for (int i = 0; i < 20; ++i)
  {
    substep(world, time / 20);
  }
}
// [substep]

} // namespace cookbook::small_world::plain_positions
