#pragma once

/// \file
/// \brief Bodies that spin freely and keep their energy to rounding, beside their angular momentum.

#include "05_resolution/spinning_bodies/spinning_bodies.hpp"

namespace cookbook
{

// [turned_with_energy]
/// A body turned by the little that gives its spin twice an energy [J]; its angular momentum stays.
///
/// A turn about m × ω, with m the angular momentum, moves the spin across both: there its energy
/// changes most. The angle is right to first order. Where it would be large, the spin is so near to
/// an axis of the body that its energy hardly depends on it, and stays as it is; and so it does
/// where rounding is all that is missing.
template <class Real>
Spinning<Real> with_twice_energy(
    const Spinning<Real>& body, const Vector3<Real>& moments, const Real& twice_energy)
{
  const Vector3<Real> spin = body.orientation.conjugate() * body.angular_velocity;
  const Vector3<Real> momentum = moments.cwiseProduct(spin), axis = momentum.cross(spin);
  const Real missing = (twice_energy - momentum.dot(spin)) / Real(2);
  const Vector3<Real> turn = axis * (missing / axis.squaredNorm());
  const Real rounding = Real(16) * std::numeric_limits<Real>::epsilon() * twice_energy;
  if (std::abs(missing) <= rounding || !(turn.norm() < Real(0.1)))
  {
    return body;
  }
  const Quaternion<Real> by = rotation_by(turn);
  const Quaternion<Real> orientation = (body.orientation * by.conjugate()).normalized();
  return {orientation, orientation * (by * momentum).cwiseQuotient(moments)};
}

/// As turned(), and then corrected twice, so that the energy stays to rounding as well; R24.
template <class Real>
Spinning<Real>
turned_with_energy(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const Vector3<Real> spin = body.orientation.conjugate() * body.angular_velocity;
  const Real twice_energy = spin.cwiseAbs2().dot(moments);
  const Spinning<Real> once =
      with_twice_energy<Real>(turned(body, moments, step), moments, twice_energy);
  return with_twice_energy<Real>(once, moments, twice_energy);
}
// [turned_with_energy]

} // namespace cookbook
