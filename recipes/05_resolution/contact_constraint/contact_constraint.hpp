#pragma once

/// \file
/// \brief A contact point as iterative solvers see it: its effective masses and accumulated
/// impulses.

#include "05_resolution/friction/friction.hpp"

namespace cookbook
{

// [contact_constraint]
/// What a solver that goes from point to point knows of a contact point of two bodies, A and B.
template <class Real>
struct ContactConstraint
{
  Vector3<Real> normal;      ///< [1], world, from A to B
  SurfaceAxes<Real> surface; ///< [1], world, across it
  Arms<Real> arms;           ///< [m], world, r_A and r_B
  Real coefficient;          ///< [1], of friction
  Real separation;           ///< [m], along the normal; negative where the surfaces overlap
  Real impulse;              ///< [N s], accumulated along the normal, zero or more
  Real total_impulse;        ///< [N s], sum of `impulse` over the substeps of a step
  Vector2<Real> friction;    ///< [N s], accumulated on B along the surface
  Real normal_mass;          ///< [kg], effective mass along the normal
  SlidingMass<Real> sliding; ///< [kg], effective mass along the surface
  /// [m/s²], along the surface: how fast the sliding velocity grows that friction allows, where a
  /// body turns
  Vector2<Real> drift = Vector2<Real>::Zero();
};

/// Computes the effective masses of a contact point for the present orientations; R1.
template <class Real>
void compute_masses(ContactConstraint<Real>& contact, const Body<Real>& a, const Body<Real>& b)
{
  contact.normal_mass = effective_mass(inverse_mass_at(a, b, contact.normal, contact.arms));
  contact.sliding = sliding_mass(a, b, contact.surface, contact.arms);
}

/// The separating velocity [m/s] along the normal at a point; negative where the surfaces approach.
template <class Real>
Real separating_velocity(
    const Body<Real>& a, const Body<Real>& b, const ContactConstraint<Real>& contact)
{
  return separating_velocity(a, b, contact.normal, contact.arms);
}
// [contact_constraint]

// [contact_impulses]
/// Adds to the impulse along the normal; the accumulated impulse never falls below zero; R7.
template <class Real>
void add_impulse(Body<Real>& a, Body<Real>& b, ContactConstraint<Real>& contact, const Real& change)
{
  const Real sum = accumulated_impulse(contact.impulse, change);
  apply_impulse<Real>(a, b, contact.arms, (sum - contact.impulse) * contact.normal);
  contact.impulse = sum;
}

/// Ends the sliding at a point by an impulse within the friction cone, a time [s] after its arms
/// were taken; R6.
template <class Real>
void add_friction(
    Body<Real>& a, Body<Real>& b, ContactConstraint<Real>& contact, const Real& elapsed = Real(0))
{
  const Vector2<Real> sliding = sliding_velocity(a, b, contact.surface, contact.arms);
  const Vector2<Real> sum = friction_impulse<Real>(
      sliding - elapsed * contact.drift, contact.sliding, contact.friction,
      contact.coefficient * contact.impulse);
  apply_impulse<Real>(a, b, contact.arms, contact.surface.in_world(sum - contact.friction));
  contact.friction = sum;
}

/// The accumulated impulse [N s] on B, normal and friction, world.
template <class Real>
Vector3<Real> contact_impulse(const ContactConstraint<Real>& contact)
{
  return contact.impulse * contact.normal + contact.surface.in_world(contact.friction);
}

/// Warm starting: applies the impulses that the frame or substep before ended with.
template <class Real>
void warm_start(Body<Real>& a, Body<Real>& b, const ContactConstraint<Real>& contact)
{
  apply_impulse<Real>(a, b, contact.arms, contact_impulse(contact));
}
// [contact_impulses]

} // namespace cookbook
