#pragma once

/// \file
/// \brief A bounce at several contact points at once: passes over them until every one is right.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "05_resolution/impulse/impulse.hpp"

#include <algorithm>
#include <array>

namespace cookbook
{

/// Two bodies after one bounce at each contact point in turn, as if the others were not there.
///
/// Right for one point. With several, each bounce sets the others moving: see the page.
template <class Real, std::size_t Capacity>
BodyPair<Real>
bounce_in_turn(BodyPair<Real> bodies, const Manifold<Real, Capacity>& manifold, Real restitution)
{
  for (const ContactPoint<Real>& point : manifold.points)
  {
    bodies = resolve_collision(bodies, manifold.normal, point.position, restitution);
  }
  return bodies;
}

// [bounce]
/// What a contact point of a bounce has got so far, and what it is to get.
template <class Real>
struct BouncePoint
{
  Arms<Real> arms; ///< [m], world
  Real mass;       ///< [kg], that a push along the normal feels
  Real target;     ///< [m/s], the separating velocity it is to have, zero or more
  Real impulse;    ///< [N s], the sum of its pushes, zero or more
};

/// A contact point before the bounce; the target is the restitution times its speed of approach.
template <class Real>
BouncePoint<Real> bounce_point(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& position,
    const Real& restitution)
{
  const Arms<Real> arms = arms_to(bodies, position);
  const Real speed = separating_velocity(bodies.a, bodies.b, normal, arms);
  const Real mass = effective_mass(inverse_mass_at(bodies.a, bodies.b, normal, arms));
  return {arms, mass, std::max(Real(0), Real(-restitution * speed)), Real(0)};
}

/// Pushes at a point until it parts at its target, or takes back what it has got; R7.
template <class Real>
void solve_point(BodyPair<Real>& bodies, const Vector3<Real>& normal, BouncePoint<Real>& point)
{
  const Real residual = point.target - separating_velocity(bodies.a, bodies.b, normal, point.arms);
  const Real sum = accumulated_impulse<Real>(point.impulse, point.mass * residual);
  apply_impulse<Real>(bodies.a, bodies.b, point.arms, (sum - point.impulse) * normal);
  point.impulse = sum;
}

/// Two bodies after a bounce at all points of a manifold, corrected point by point, pass by pass.
///
/// More passes come closer to R5 at every point at once; one point needs one pass. Two immovable
/// bodies stay as they are.
template <class Real, std::size_t Capacity>
BodyPair<Real> bounce(
    BodyPair<Real> bodies, const Manifold<Real, Capacity>& manifold, Real restitution, int passes)
{
  std::array<BouncePoint<Real>, Capacity> points;
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
  {
    points[i] = bounce_point(bodies, manifold.normal, manifold.points[i].position, restitution);
  }
  for (int pass = 0; pass < passes; ++pass)
  {
    for (std::size_t i = 0; i < manifold.points.size(); ++i)
    {
      solve_point(bodies, manifold.normal, points[i]);
    }
  }
  return bodies;
}
// [bounce]

} // namespace cookbook
