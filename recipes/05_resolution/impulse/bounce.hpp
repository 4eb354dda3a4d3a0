#pragma once

/// \file
/// \brief A bounce at several contact points at once: passes over them until every one is right.

#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "05_resolution/impulse/impulse.hpp"

#include <algorithm>
#include <array>

namespace cookbook
{

// [bounce_in_turn]
/// Two bodies after one bounce at each contact point in turn, as if the others were not there.
///
/// Right for one point. With several, each bounce sets the others moving: see the page.
template <class Real, std::size_t Capacity>
BodyPair<Real>
bounce_in_turn(BodyPair<Real> bodies, const Manifold<Real, Capacity>& manifold, Real restitution)
{
  for (const ContactPoint<Real>& point : manifold.points)
  {
    bodies = collide(bodies, manifold.normal, point.position, restitution);
  }
  return bodies;
}
// [bounce_in_turn]

// [bounce]
/// What a contact point of a bounce has got so far, and what it is to get.
template <class Real>
struct BouncePoint
{
  Vector3<Real> position; ///< [m], world
  Real inverse_mass;      ///< [1/kg], K
  Real target;            ///< [m/s], the parting speed it is to have, zero or more
  Real impulse;           ///< [N s], the sum of its pushes, zero or more
};

/// A contact point before the bounce; the target is the restitution times its speed of approach.
template <class Real>
BouncePoint<Real> bounce_point(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& position,
    Real restitution)
{
  const Real speed = parting_speed(bodies, normal, position);
  const Real target = std::max(Real(0), Real(-restitution * speed));
  return {position, inverse_mass_at(bodies, normal, position), target, Real(0)};
}

/// The push [N s] that takes a point to its target, or takes back at most what it has got; none
/// where no push moves the point.
template <class Real>
Real correction(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const BouncePoint<Real>& point)
{
  if (point.inverse_mass == Real(0))
  {
    return Real(0);
  }
  const Real missing = point.target - parting_speed(bodies, normal, point.position);
  return std::max(Real(-point.impulse), Real(missing / point.inverse_mass));
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
      const Real change = correction(bodies, manifold.normal, points[i]);
      bodies = pushed_apart(bodies, manifold.normal, points[i].position, change);
      points[i].impulse += change;
    }
  }
  return bodies;
}
// [bounce]

} // namespace cookbook
