#pragma once

/// \file
/// \brief Friction at a contact point: one impulse along the surface, no longer than its cone lets
/// it be.

#include "05_resolution/impulse/impulse.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [sliding_velocity]
/// The velocity [m/s] with which B's surface slides over A's at a contact point.
template <class Real>
Vector3<Real> sliding_velocity(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point)
{
  const Vector3<Real> velocity = relative_velocity(bodies.a.motion, bodies.b.motion, point);
  return velocity - velocity.dot(normal) * normal;
}
// [sliding_velocity]

// [within_cone]
/// An impulse [N s] along the surface, shortened to at most a length [N s]: the cone's cut; R6.
///
/// A length of zero or less leaves none.
template <class Real>
Vector3<Real> within_cone(const Vector3<Real>& impulse, const Real& most)
{
  const Real length = impulse.norm();
  if (length <= most)
  {
    return impulse;
  }
  return impulse * (std::max(Real(0), most) / length);
}
// [within_cone]

// [sliding_inverse_mass]
/// How much speed [m/s] along one direction of the surface one newton second along another gives a
/// body at a point [1/kg].
template <class Real>
Real coupling_at(
    const Body<Real>& body, const Vector3<Real>& along, const Vector3<Real>& other,
    const Vector3<Real>& point)
{
  const Vector3<Real> arm = point - body.motion.center;
  const Vector3<Real> turn = body.inverse_inertia * arm.cross(other);
  return body.inverse_mass * along.dot(other) + arm.cross(along).dot(turn);
}

/// K [1/kg] along the surface, in the direction in which it is largest.
///
/// Zero where no push moves the point. It stays as it is while impulses are found.
template <class Real>
Real sliding_inverse_mass(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point)
{
  using std::sqrt;
  const Vector3<Real> u = normal.unitOrthogonal();
  const Vector3<Real> v = normal.cross(u);
  const Real half(Real(1) / Real(2));
  const Real uu = inverse_mass_at(bodies, u, point), vv = inverse_mass_at(bodies, v, point);
  const Real uv = coupling_at(bodies.a, u, v, point) + coupling_at(bodies.b, u, v, point);
  const Real apart = half * (uu - vv);
  return half * (uu + vv) + sqrt(apart * apart + uv * uv);
}
// [sliding_inverse_mass]

// [friction_impulse]
/// The impulse [N s] on B that goes against the sliding at a contact point, with what friction has
/// given there so far; R6 is still to be asked.
///
/// `inverse_mass` [1/kg] is `sliding_inverse_mass`. As it is for the direction that moves most, no
/// direction is pushed beyond rest. Nothing is added where no push moves the point.
template <class Real>
Vector3<Real> gripping_impulse(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    const Vector3<Real>& so_far, const Real& inverse_mass)
{
  if (inverse_mass == Real(0))
  {
    return so_far;
  }
  return so_far - sliding_velocity(bodies, normal, point) / inverse_mass;
}

/// The impulse [N s] of friction on B after one more visit to a contact point: what goes against
/// the sliding, but at most μ times the normal impulse, `most` [N s]; R6.
///
/// `so_far` is what earlier visits gave, and only the difference is still to be given: it may be
/// one that takes back.
template <class Real>
Vector3<Real> friction_impulse(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    const Vector3<Real>& so_far, const Real& inverse_mass, const Real& most)
{
  return within_cone(gripping_impulse(bodies, normal, point, so_far, inverse_mass), most);
}
// [friction_impulse]

// [rubbed]
/// Two bodies after an impulse [N s] along the surface: as much on B as against it on A; R3.
template <class Real>
BodyPair<Real>
rubbed(const BodyPair<Real>& bodies, const Vector3<Real>& point, const Vector3<Real>& impulse)
{
  return {pushed<Real>(bodies.a, -impulse, point), pushed<Real>(bodies.b, impulse, point)};
}
// [rubbed]

} // namespace cookbook
