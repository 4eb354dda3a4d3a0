#pragma once

/// \file
/// \brief The impulse that makes two bodies bounce at a contact point, and what it changes.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "05_resolution/impulse/body.hpp"

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
// [body_pair]

// [inverse_mass]
/// How much speed [m/s] along the normal, at a contact point, one newton second gives a body: its
/// inverse mass [1/kg] as felt there; R1.
///
/// Zero for an immovable body. The lever is zero where the push goes through the centre of mass.
template <class Real>
Real inverse_mass_at(
    const Body<Real>& body, const Vector3<Real>& normal, const Vector3<Real>& point)
{
  const Vector3<Real> lever = (point - body.motion.center).cross(normal);
  return body.inverse_mass + lever.dot(body.inverse_inertia * lever);
}

/// The same of two bodies that are pushed apart: K [1/kg]; R1.
template <class Real>
Real inverse_mass_at(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point)
{
  return inverse_mass_at(bodies.a, normal, point) + inverse_mass_at(bodies.b, normal, point);
}
// [inverse_mass]

// [impulse]
/// How fast [m/s] two surfaces part at a contact point; negative where they approach.
template <class Real>
Real parting_speed(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point)
{
  return relative_velocity(bodies.a.motion, bodies.b.motion, point).dot(normal);
}

/// The impulse [N s] along the normal of a bounce with a restitution [1], 0 to 1; R2.
///
/// Zero where the surfaces part or rest already, and where both bodies are immovable.
template <class Real>
Real bounce_impulse(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    Real restitution)
{
  const Real speed = parting_speed(bodies, normal, point);
  const Real inverse_mass = inverse_mass_at(bodies, normal, point);
  if (speed >= Real(0) || inverse_mass == Real(0))
  {
    return Real(0);
  }
  return -(Real(1) + restitution) * speed / inverse_mass;
}
// [impulse]

// [pushed]
/// A body after an impulse [N s], world, at a point [m], world.
template <class Real>
Body<Real> pushed(Body<Real> body, const Vector3<Real>& impulse, const Vector3<Real>& point)
{
  const Vector3<Real> arm = point - body.motion.center;
  body.motion.velocity += body.inverse_mass * impulse;
  body.motion.angular_velocity += body.inverse_inertia * arm.cross(impulse);
  return body;
}

/// Two bodies after an impulse [N s] apart: as much against the normal on A as along it on B; R3.
template <class Real>
BodyPair<Real> pushed_apart(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    Real impulse)
{
  const Vector3<Real> push = impulse * normal;
  return {pushed<Real>(bodies.a, -push, point), pushed<Real>(bodies.b, push, point)};
}
// [pushed]

// [collide]
/// Two bodies after they bounced at one contact point; R5.
///
/// They stay as they are where `bounce_impulse` is zero.
template <class Real>
BodyPair<Real> collide(
    const BodyPair<Real>& bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    Real restitution)
{
  const Real impulse = bounce_impulse(bodies, normal, point, restitution);
  return pushed_apart(bodies, normal, point, impulse);
}
// [collide]

} // namespace cookbook
