#pragma once

/// \file
/// \brief Bodies that spin freely, by small turns: about the mean of the spins before and after.

#include "05_resolution/spinning_bodies/spinning_bodies.hpp"
#include "common/simd/number.hpp"

namespace cookbook
{

// [turns_little]
/// The largest turn [rad] that is little for a ball. For another body it is less, by as much as
/// its least moment is less than its largest.
inline constexpr double little_turn = 0.2;

/// Whether a body of these moments [kg m²] turns little, for turned_about_mean(), by a turn [rad]
/// of zero or more.
template <class Real>
bool turns_little(const Vector3<Real>& moments, Real turn)
{
  return turn * moments.maxCoeff() < Real(little_turn) * moments.minCoeff();
}
// [turns_little]

// [turned_about_mean]
/// A vector along half a turn [rad], as long as its tangent; for small turns.
template <class Real>
Vector3<Real> half_tangent(const Vector3<Real>& half)
{
  const Real square = half.squaredNorm();
  return half * (Real(1) + square * (Real(1.0 / 3) + square * Real(2.0 / 15)));
}

/// A body of these moments [kg m²] after it has spun freely for a step [s], in which it turns
/// little: about the mean of its spins before and after; R24. Packs: a body in every lane.
///
/// Angular momentum and energy stay as they are to rounding; of second order. Each round leaves a
/// tenth at most of what the mean is off by.
template <class Real>
Spinning<Real>
turned_about_mean(const Spinning<Real>& body, const Vector3<Real>& moments, const Real& step)
{
  const Real largest = larger(larger(moments.x(), moments.y()), moments.z());
  const Vector3<Real> relative = moments / largest;
  const Vector3<Real> half_rates = (Real(0.5) * step) * relative.cwiseInverse();
  const Vector3<Real> momentum = tumbling<Real>(body, relative).momentum;
  Vector3<Real> mean = momentum, tangent;
  for (int round = 0; round < 16; ++round)
  {
    tangent = half_tangent<Real>(half_rates.cwiseProduct(mean));
    const Vector3<Real> before = mean;
    mean = momentum + mean.cross(tangent);
    if (!any((mean - before).squaredNorm() > Real(0)))
    {
      break;
    }
  }
  const Quaternion<Real> turn(Real(1), tangent.x(), tangent.y(), tangent.z());
  const Quaternion<Real> turned = body.orientation * turn;
  const Quaternion<Real> orientation(turned.coeffs() / turned.norm());
  return spinning<Real>({orientation, mean + mean - momentum}, relative);
}
// [turned_about_mean]

} // namespace cookbook
