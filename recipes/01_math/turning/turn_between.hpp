#pragma once

/// \file
/// \brief The rotation vector that leads from one orientation to another.

#include "common/math/trigonometry.hpp"
#include "common/math/vector.hpp"

#include <cmath>

namespace cookbook
{

// [turn_between]
/// The rotation vector [rad] that leads from one orientation to another, the shorter way round:
/// what rotation_by() takes. Both orientations have length one.
template <class Real>
Vector3<Real> turn_between(const Quaternion<Real>& from, const Quaternion<Real>& to)
{
  const Quaternion<Real> turned = to * from.conjugate();
  const Vector3<Real> sine = turned.w() < Real(0) ? Vector3<Real>(-turned.vec()) : turned.vec();
  const Real length = sine.norm();
  const Real half_angle = arc_tangent<Real>(length, std::abs(turned.w()));
  return (length > Real(0) ? 2 * half_angle / length : Real(2)) * sine;
}
// [turn_between]

} // namespace cookbook
