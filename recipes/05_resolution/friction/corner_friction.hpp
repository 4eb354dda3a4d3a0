#pragma once

/// \file
/// \brief Friction where two bodies press on each other at a single point: against turning there.

#include "05_resolution/friction/friction.hpp"

#include <limits>

namespace cookbook
{

// [torsional_friction]
/// Takes away what two bodies turn against each other, by an impulse [N m s] no larger than
/// `max_impulse`.
///
/// Nothing changes where there is a direction about which, to rounding, neither can be turned.
template <class Real>
void apply_torsional_friction(Body<Real>& a, Body<Real>& b, const Real& max_impulse)
{
  const Matrix3<Real> inverse_mass = a.inverse_inertia + b.inverse_inertia;
  const Real scale = inverse_mass.cwiseAbs().maxCoeff();
  const Matrix3<Real> relative = inverse_mass / scale;
  if (!(relative.determinant() > std::numeric_limits<Real>::epsilon()))
  {
    return;
  }
  const Vector3<Real> turning = b.motion.angular_velocity - a.motion.angular_velocity;
  const Vector3<Real> matrix = -relative.inverse() * turning / scale;
  const Vector3<Real> impulse = within_cone<Real, 3>(matrix, max_impulse);
  a.motion.angular_velocity -= a.inverse_inertia * impulse;
  b.motion.angular_velocity += b.inverse_inertia * impulse;
}
// [torsional_friction]

} // namespace cookbook
