#pragma once

/// \file
/// \brief The impulse that makes two bodies bounce at a contact point, and what it changes.

#include "05_resolution/impulse/contact_impulse.hpp"

#include <algorithm>

namespace cookbook
{

// [body_pair]
/// Two bodies that meet; normals point from A to B.
template <class Real>
struct BodyPair
{
  Body<Real> a; ///< pushed against the normal
  Body<Real> b; ///< pushed along the normal
};

/// The arms of two bodies that touch at one point [m], world.
template <class Real>
Arms<Real> arms_to(const BodyPair<Real>& bodies, const Vector3<Real>& point)
{
  return {point - bodies.a.motion.center, point - bodies.b.motion.center};
}
// [body_pair]

// [impulse]
/// The impulse [N s] along the normal of a bounce with a restitution [1], 0 to 1; R2.
///
/// Zero where the surfaces part or rest already, and where both bodies are immovable.
template <class Real>
Real bounce_impulse(
    const Body<Real>& a, const Body<Real>& b, const Vector3<Real>& normal, const Arms<Real>& arms,
    const Real& restitution)
{
  const Real speed = std::min(Real(0), separating_velocity(a, b, normal, arms));
  const Real mass = effective_mass(inverse_mass_at(a, b, normal, arms));
  return -(Real(1) + restitution) * speed * mass;
}
// [impulse]

// [resolve_collision]
/// Two bodies after they bounced at one contact point [m], world; R5.
///
/// They stay as they are where `bounce_impulse` is zero.
template <class Real>
BodyPair<Real> resolve_collision(
    BodyPair<Real> bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    const Real& restitution)
{
  const Arms<Real> arms = arms_to(bodies, point);
  const Real impulse = bounce_impulse(bodies.a, bodies.b, normal, arms, restitution);
  apply_impulse<Real>(bodies.a, bodies.b, arms, impulse * normal);
  return bodies;
}
// [resolve_collision]

} // namespace cookbook
