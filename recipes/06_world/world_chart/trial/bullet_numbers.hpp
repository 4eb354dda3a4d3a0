#pragma once

/// \file
/// \brief Vectors and rotations of ours as Bullet's, and back.

#if defined(COOKBOOK_HAS_BULLET)

#include "common/math/vector.hpp"

#include <LinearMath/btTransform.h>

namespace cookbook
{

/// A vector as Bullet has it, rounded to its scalar type.
inline btVector3 to_bullet(const Vector3<double>& v)
{
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// A rotation likewise.
inline btQuaternion to_bullet(const Quaternion<double>& q)
{
  const Quaternion<btScalar> rounded = q.cast<btScalar>();
  return {rounded.x(), rounded.y(), rounded.z(), rounded.w()};
}

/// A vector of Bullet's.
inline Vector3<double> from_bullet(const btVector3& v)
{
  return {double(v.x()), double(v.y()), double(v.z())};
}

/// A rotation of Bullet's.
inline Quaternion<double> from_bullet(const btQuaternion& q)
{
  return {double(q.w()), double(q.x()), double(q.y()), double(q.z())};
}

} // namespace cookbook

#endif
