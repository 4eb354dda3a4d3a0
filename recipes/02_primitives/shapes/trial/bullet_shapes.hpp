#pragma once

/// \file
/// \brief Vectors and rays as Bullet has them.

#ifdef COOKBOOK_HAS_BULLET
#include "02_primitives/shapes/shapes.hpp"

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include <optional>

namespace cookbook
{

/// A vector of ours as one of Bullet's.
inline btVector3 of_bullet(const Vector3<float>& v)
{
  return {v.x(), v.y(), v.z()};
}

/// The nearest triangle that a ray meets; Bullet's rays end, here at t = `reach`.
class BulletRay : public btTriangleRaycastCallback
{
public:
  /// The ray from t = 0 to `reach`.
  BulletRay(const Ray<float>& ray, float length)
      : btTriangleRaycastCallback(
            of_bullet(ray.origin), of_bullet(ray.origin + length * ray.direction)),
        length_(length)
  {
  }

  btScalar reportHit(const btVector3&, btScalar fraction, int, int) override { return fraction; }

  /// The t of the nearest of all triangles so far.
  std::optional<float> t() const
  {
    return m_hitFraction < 1 ? std::optional(length_ * m_hitFraction) : std::nullopt;
  }

private:
  float length_;
};

} // namespace cookbook
#endif
