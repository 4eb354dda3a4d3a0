#pragma once

/// \file
/// \brief The rotation of a steady spin, whatever the time: the exponential of a quaternion.

#include "common/math/vector.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [half_turn]
/// Cosine and sine of half an angle.
template <class Real>
struct HalfTurn
{
  Real cosine; ///< [1]
  Real sine;   ///< [1]
};

/// Cosine and sine of half an angle [rad], right to rounding.
///
/// A small angle, half a radian or less, takes a third of the time: the tangent of its fourth part
/// is a fraction, and cosine and sine follow from that without a root.
template <class Real>
HalfTurn<Real> half_turn(Real angle)
{
  const Real y = angle / 4, square = y * y;
  if (!(square <= Real(1) / 64))
  {
    return {std::cos(angle / 2), std::sin(angle / 2)};
  }
  const Real above = y * (945 + square * (square - 105));
  const Real below = 945 + square * (15 * square - 420);
  const Real scale = 1 / (below * below + above * above);
  return {(below * below - above * above) * scale, 2 * above * below * scale};
}
// [half_turn]

// [rotation_by]
/// The rotation about the direction of a vector by its length [rad]; M9.
///
/// Zero is no turn, and neither is an angle of 1/ε or more: no digit of it would be left. Not a
/// number comes out as it went in.
template <class Real>
Quaternion<Real> rotation_by(const Vector3<Real>& turn)
{
  const Real angle = turn.norm();
  if (angle * std::numeric_limits<Real>::epsilon() >= Real(1))
  {
    return Quaternion<Real>::Identity();
  }
  const HalfTurn<Real> half = half_turn(angle);
  const Real fraction = angle == Real(0) ? Real(0.5) : half.sine / angle;
  return {half.cosine, fraction * turn.x(), fraction * turn.y(), fraction * turn.z()};
}
// [rotation_by]

} // namespace cookbook
