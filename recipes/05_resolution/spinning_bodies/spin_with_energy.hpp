#pragma once

/// \file
/// \brief Bodies that spin freely and keep their energy to rounding, beside their angular momentum.

#include "05_resolution/spinning_bodies/spinning_bodies.hpp"

namespace cookbook
{

// [turned_with_energy]
/// A body turned by the little that gives its spin twice an energy; its angular momentum stays.
///
/// A turn about m × ω, with m the angular momentum, moves the spin across both: there its energy
/// changes most. The angle is right to first order. Where it would be large, the spin is so near to
/// an axis of the body that its energy hardly depends on it, and stays as it is; and so it does
/// where rounding is all that is missing.
template <class Real>
Tumbling<Real>
with_twice_energy(const Tumbling<Real>& body, const SpinAxes<Real>& axes, const Real& twice_energy)
{
  const Vector3<Real> spin = body.momentum.cwiseQuotient(axes.moments);
  const Vector3<Real> axis = body.momentum.cross(spin);
  const Real missing = (twice_energy - body.momentum.dot(spin)) / Real(2);
  const Real rounding = Real(16) * std::numeric_limits<Real>::epsilon() * twice_energy;
  if (std::abs(missing) <= rounding)
  {
    return body;
  }
  const Vector3<Real> turn = axis * (missing / axis.squaredNorm());
  if (!(turn.norm() < Real(0.1)))
  {
    return body;
  }
  const Quaternion<Real> by = rotation_by(turn);
  return {(body.orientation * by.conjugate()).normalized(), by * body.momentum};
}

/// As turned(), and then corrected twice, so that the energy stays to rounding as well; R24.
template <class Real>
Spinning<Real>
turned_with_energy(const Spinning<Real>& body, const Vector3<Real>& moments, Real step)
{
  const SpinAxes<Real> axes = spin_axes(moments);
  if (turns_evenly(body, axes, step))
  {
    return turned_evenly(body, step);
  }
  const Tumbling<Real> now = tumbling(body, axes.moments);
  const Real twice_energy = now.momentum.cwiseAbs2().cwiseQuotient(axes.moments).sum();
  const Tumbling<Real> once = with_twice_energy(spun(now, axes, step), axes, twice_energy);
  return spinning(with_twice_energy(once, axes, twice_energy), axes.moments);
}
// [turned_with_energy]

} // namespace cookbook
