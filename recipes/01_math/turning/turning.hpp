#pragma once

/// \file
/// \brief Turning an orientation by an angular velocity, frame after frame.

#include "01_math/rotations/unit_quaternion.hpp"
#include "01_math/turning/rotation_by.hpp"
#include "01_math/turning/turn_between.hpp"

namespace cookbook
{

// [turned_by]
/// An orientation after a time step [s] of a steady angular velocity [rad/s], seen from the world;
/// M9. The answer has length one to rounding, whatever the orientation's.
///
/// A turn of 1/ε or more in one step, of which no digit would be left, is none.
template <class Real>
Quaternion<Real> turned_by(
    const Quaternion<Real>& orientation, const Vector3<Real>& angular_velocity, const Real& step)
{
  return product(rotation_by<Real>(step * angular_velocity), unit_quaternion(orientation));
}
// [turned_by]

} // namespace cookbook
