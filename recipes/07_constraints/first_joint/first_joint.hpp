#pragma once

/// \file
/// \brief The first joint: a point on a rod about the origin, held by a constraint.

#include "05_resolution/integrators/integrators.hpp"
#include "common/math/norm.hpp"

namespace cookbook
{

// [rod_step]
/// A rod about the origin, without mass, with a point at its end.
template <class Real>
struct Rod
{
  Real length;      ///< [m]
  Real beta = 1;    ///< [1], fraction of the error that a step corrects, 0 to 1
  Real turning = 1; ///< [1], 1 where what turning adds is counted, 0 where it is not
};

/// The point after a step [s] under gravity [m/s²]; R41, R42.
///
/// The velocity gets gravity, and then the impulse that holds it on the rod. A point at the origin
/// has no direction; its rod is taken to point up, along +y.
template <class Real>
PhasePoint<Vector3<Real>> rod_step(
    const PhasePoint<Vector3<Real>>& from, const Rod<Real>& rod, const Vector3<Real>& gravity,
    const Real& step)
{
  const Vector3<Real> velocity = from.velocity + step * gravity;
  const Direction<Real> line = normalize(from.position); // its unit vector is J, transposed
  const Real error = line.length - rod.length;           // C
  const Real speed = line.unit.dot(velocity);            // J v
  const Real around = (velocity - speed * line.unit).squaredNorm();
  const Real centripetal = line.length == Real(0) ? Real(0) : Real(around / line.length);
  const Real bias = rod.beta / step * error + rod.turning * step / Real(2) * centripetal;
  const Vector3<Real> held = velocity - (speed + bias) * line.unit; // the mass cancels
  return {from.position + step * held, held};
}
// [rod_step]

} // namespace cookbook
