#pragma once

/// \file
/// \brief Turning an orientation by an angular velocity, frame after frame.

#include "01_math/rotations/unit_quaternion.hpp"
#include "01_math/turning/rotation_by.hpp"

#include <cmath>

namespace cookbook
{

// [repaired]
/// A quaternion that rounding has moved off length one, brought back: by a series without a
/// root where its squared length is off by no more than 4e-6, else as unit_quaternion() does.
template <class Real>
Quaternion<Real> repaired(const Quaternion<Real>& q)
{
  using std::abs;
  const Real excess = q.squaredNorm() - Real(1);
  // 1/√(1 + excess) begins like this; the next term, 5/16 excess³, is less than a rounding.
  return abs(excess) <= Real(4e-6)
             ? Quaternion<Real>(
                   q.coeffs() * (Real(1) - excess * (Real(0.5) - Real(0.375) * excess)))
             : unit_quaternion(q);
}
// [repaired]

// [turned_by]
/// An orientation after a time step [s] of a steady angular velocity [rad/s], seen from the world;
/// M9. The answer has length one, whatever the orientation's.
///
/// A turn of 1/ε or more in one step, of which no digit would be left, is none.
template <class Real>
Quaternion<Real> turned_by(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, const Real& step)
{
  return repaired(Quaternion<Real>(rotation_by<Real>(step * angular_velocity) * orientation));
}
// [turned_by]

} // namespace cookbook
