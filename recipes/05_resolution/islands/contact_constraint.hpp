#pragma once

/// \file
/// \brief What a solver that goes from contact point to contact point knows of one, and how it
/// pushes there.

#include "05_resolution/friction/friction.hpp"

namespace cookbook
{

// [contact_constraint]
/// A contact point of two bodies, A and B; of packs, one in every lane.
template <class Real>
struct ContactConstraint
{
  Vector3<Real> normal;      ///< [1], world, from A to B
  SurfaceAxes<Real> surface; ///< [1], world, across it
  Arms<Real> arms;           ///< [m], world, as a solver has taken them
  Real coefficient;          ///< [1], of friction
  Real apart;                ///< [m], the gap; solvers with small steps carry it on
  Real impulse;              ///< [N s], given along the normal so far, zero or more
  Real sum;                  ///< [N s], of that over the small steps of a step
  Vector2<Real> friction;    ///< [N s], given to B along the surface so far
  Real normal_mass;          ///< [kg], that an impulse along the normal feels
  SlidingMass<Real> sliding; ///< [kg], what one across it feels
};

/// Finds what impulses at a point feel, with the bodies as they are turned now; R1.
template <class Real>
void find_masses(ContactConstraint<Real>& at, const Body<Real>& a, const Body<Real>& b)
{
  at.normal_mass = effective_mass(inverse_mass_at(a, b, at.normal, at.arms));
  at.sliding = sliding_mass(a, b, at.surface, at.arms);
}

/// How fast [m/s] the surfaces part at a point.
template <class Real>
Real parting_speed(const Body<Real>& a, const Body<Real>& b, const ContactConstraint<Real>& at)
{
  return parting_speed(a, b, at.normal, at.arms);
}
// [contact_constraint]

// [pushes]
/// Pushes along the normal at a point, or takes back at most what it has got; R7.
template <class Real>
void add_impulse(Body<Real>& a, Body<Real>& b, ContactConstraint<Real>& at, const Real& change)
{
  const Real sum = accumulated(at.impulse, change);
  push_apart<Real>(a, b, at.arms, (sum - at.impulse) * at.normal);
  at.impulse = sum;
}

/// Takes away what slips at a point, with a friction within the cone; R6.
template <class Real>
void add_friction(Body<Real>& a, Body<Real>& b, ContactConstraint<Real>& at)
{
  const Vector2<Real> sum = friction_impulse<Real>(
      sliding_velocity(a, b, at.surface, at.arms), at.sliding, at.friction,
      at.coefficient * at.impulse);
  push_apart<Real>(a, b, at.arms, at.surface.in_world(sum - at.friction));
  at.friction = sum;
}

/// All that a point has been given [N s], on B, world.
template <class Real>
Vector3<Real> given(const ContactConstraint<Real>& at)
{
  return at.impulse * at.normal + at.surface.in_world(at.friction);
}

/// Gives the bodies once more what the frame before, or the step before, has ended with.
template <class Real>
void warm_start(Body<Real>& a, Body<Real>& b, const ContactConstraint<Real>& at)
{
  push_apart<Real>(a, b, at.arms, given(at));
}
// [pushes]

} // namespace cookbook
