#pragma once

/// \file
/// \brief Rotations: by axis and angle, by three angles, by quaternions, and from one to another.

#include "01_math/rotations/euler_angles.hpp"
#include "01_math/rotations/quaternion_of.hpp"
#include "01_math/rotations/rotation_between.hpp"
#include "01_math/rotations/slerp.hpp"
#include "01_math/rotations/unit_quaternion.hpp"
#include "common/math/rotation.hpp"

namespace cookbook
{

// [turned_vector]
/// q v q*: the vector v turned by the quaternion q of length one, by two products of quaternions.
template <class Real>
Vector3<Real> turned_vector(const Quaternion<Real>& q, const Vector3<Real>& v)
{
  const Quaternion<Real> as_quaternion(Real(0), v.x(), v.y(), v.z());
  return product<Real>(product(q, as_quaternion), q.conjugate()).vec();
}
// [turned_vector]

} // namespace cookbook
