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

/// Cosine and sine of half an angle [rad], by quotients alone: the same bits with each compiler.
///
/// The tangent of a fourth of half a radian or less is a fraction; cosine and sine of a larger
/// fourth follow from its half, and each doubling doubles what was rounded: within 2 + 2 angle ulp
/// of one. Not a number if the angle's square overflows.
template <class Real>
HalfTurn<Real> half_turn(Real angle)
{
  const Real y = angle / 4, square = y * y;
  const bool large = square > Real(1) / 64 && square <= std::numeric_limits<Real>::max();
  const HalfTurn<Real> fourth =
      large
          ? half_turn(angle / 2)
          : HalfTurn<Real>{945 + square * (15 * square - 420), y * (945 + square * (square - 105))};
  const Real c = fourth.cosine, s = fourth.sine, scale = 1 / (c * c + s * s);
  return {(c * c - s * s) * scale, 2 * s * c * scale};
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
