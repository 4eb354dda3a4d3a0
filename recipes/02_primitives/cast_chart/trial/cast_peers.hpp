#pragma once

/// \file
/// \brief Bullet's casts at a box and at a triangle, to be timed beside ours.

#include "02_primitives/shapes/more_shapes.hpp"
#include "02_primitives/shapes/trial/bullet_shapes.hpp"

#ifdef COOKBOOK_HAS_BULLET
#include <LinearMath/btAabbUtil2.h>
#endif

#include <limits>
#include <optional>

namespace cookbook
{

#ifdef COOKBOOK_HAS_BULLET
/// Bullet's slabs, with the inverse that it asks for.
inline std::optional<float> bullet_box(const Ray<float>& ray, const Aabb<float>& box)
{
  const Vector3<float> inverse = ray.direction.cwiseInverse();
  const btVector3 bounds[] = {of_bullet(box.min()), of_bullet(box.max())};
  const unsigned int sign[] = {inverse.x() < 0, inverse.y() < 0, inverse.z() < 0};
  btScalar t = 0;
  const bool hit = btRayAabb2(
      of_bullet(ray.origin), of_bullet(inverse), sign, bounds, t, 0,
      std::numeric_limits<btScalar>::max());
  return hit ? std::optional(float(t)) : std::nullopt;
}

/// Bullet's triangles, which it meets on a way from 0 to 1: a ray of 20 km here.
inline std::optional<float> bullet_triangle(const Ray<float>& ray, const Triangle<float>& triangle)
{
  BulletRay met(ray, 20000);
  btVector3 corners[] = {of_bullet(triangle.a), of_bullet(triangle.b), of_bullet(triangle.c)};
  met.processTriangle(corners, 0, 0);
  return met.t();
}
#endif

} // namespace cookbook
