#pragma once

/// \file
/// \brief The manifold of a sphere and a capsule, as the formula stands.

#include "02_primitives/plain_points/plain_points.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_sphere_sphere.hpp"

namespace cookbook
{

// [plain_sphere_capsule]
/// The manifold of a sphere A and a capsule B: the sphere against the one sphere of the capsule
/// whose centre is closest; P2.
template <class Real>
std::optional<Manifold<Real>>
plain_sphere_capsule(const Sphere<Real>& sphere, const Capsule<Real>& capsule)
{
  const Vector3<Real> closest = closest_point(capsule.segment, sphere.center);
  return plain_sphere_sphere<Real>(sphere, {closest, capsule.radius});
}
// [plain_sphere_capsule]

} // namespace cookbook
