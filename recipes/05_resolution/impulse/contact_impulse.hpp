#pragma once

/// \file
/// \brief An impulse at a contact point of two bodies: the mass that it feels, and what it changes.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "05_resolution/impulse/body.hpp"

#include <algorithm>

namespace cookbook
{

// [arms]
/// The arms of a contact point, \f$ r_A \f$ and \f$ r_B \f$: from the centre of mass of each body
/// to where it touches.
template <class Real>
struct Arms
{
  Vector3<Real> a; ///< [m], world, on A
  Vector3<Real> b; ///< [m], world, on B
};
// [arms]

// [inverse_mass]
/// How much speed [m/s] along a unit direction, at an arm [m], world, one newton second gives a
/// body: its inverse mass [1/kg] as felt there; R1.
///
/// Zero for an immovable body. The lever is zero where the push goes through the centre of mass.
template <class Real>
Real inverse_mass_at(
    const Body<Real>& body, const Vector3<Real>& direction, const Vector3<Real>& arm)
{
  const Vector3<Real> lever = arm.cross(direction);
  return body.inverse_mass + lever.dot(body.inverse_inertia * lever);
}

/// The same of two bodies that are pushed apart: K [1/kg]; R1.
template <class Real>
Real inverse_mass_at(
    const Body<Real>& a, const Body<Real>& b, const Vector3<Real>& direction,
    const Arms<Real>& arms)
{
  return inverse_mass_at(a, direction, arms.a) + inverse_mass_at(b, direction, arms.b);
}

/// The first of two, if a test says so; otherwise what the second gives. So it can be asked of
/// packs, too, which choose in every lane.
template <class Any, class Second>
Any either(bool first, const Any& yes, const Second& second)
{
  return first ? yes : Any(second());
}

/// The mass [kg] that a push feels, 1/K; zero where no push moves the point.
template <class Real>
Real effective_mass(const Real& inverse_mass)
{
  return either(inverse_mass <= Real(0), Real(0), [&] { return Real(1) / inverse_mass; });
}
// [inverse_mass]

// [separating_velocity]
/// Velocity [m/s] of B's surface at a contact point as seen from A's; S11.
template <class Real>
Vector3<Real>
relative_velocity(const Motion<Real>& a, const Motion<Real>& b, const Arms<Real>& arms)
{
  return velocity_at_arm(b, arms.b) - velocity_at_arm(a, arms.a);
}

/// How fast [m/s] two surfaces part at a contact point; negative where they approach.
template <class Real>
Real separating_velocity(
    const Body<Real>& a, const Body<Real>& b, const Vector3<Real>& normal, const Arms<Real>& arms)
{
  return relative_velocity(a.motion, b.motion, arms).dot(normal);
}
// [separating_velocity]

// [apply_impulse]
/// Gives a body an impulse [N s], world, at an arm [m], world.
template <class Real>
void apply_impulse(Body<Real>& body, const Vector3<Real>& arm, const Vector3<Real>& impulse)
{
  body.motion.velocity += body.inverse_mass * impulse;
  body.motion.angular_velocity += body.inverse_inertia * arm.cross(impulse);
}

/// Gives B an impulse [N s], world, at a contact point, and A its opposite; R3.
template <class Real>
void apply_impulse(
    Body<Real>& a, Body<Real>& b, const Arms<Real>& arms, const Vector3<Real>& impulse)
{
  apply_impulse<Real>(a, arms.a, -impulse);
  apply_impulse<Real>(b, arms.b, impulse);
}
// [apply_impulse]

// [accumulated_impulse]
/// What a contact point has been given along its normal [N s] after one more push: never less than
/// nothing, for a push can be taken back, but a contact does not pull; R7.
template <class Real>
Real accumulated_impulse(const Real& accumulated, const Real& change)
{
  using std::max;
  return max(Real(0), Real(accumulated + change));
}
// [accumulated_impulse]

} // namespace cookbook
