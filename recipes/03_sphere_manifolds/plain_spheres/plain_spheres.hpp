#pragma once

/// \file
/// \brief The manifold of a sphere and a sphere, a plane, a capsule, a box: the formulas as they
/// stand, for a room.

#include "02_primitives/plain_points/plain_points.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_sphere_box.hpp"

namespace cookbook
{

// [plain_sphere_plane]
/// The manifold of a sphere A and the half-space B below a plane, however deep the sphere is; P1.
template <class Real>
std::optional<Manifold<Real>>
plain_sphere_plane(const Sphere<Real>& sphere, const Plane<Real>& plane)
{
  const Real depth = sphere.radius - signed_distance(plane, sphere.center);
  if (depth < 0)
  {
    return std::nullopt;
  }
  const Vector3<Real> normal = -plane.normal;
  const Vector3<Real> point = sphere.center + (sphere.radius - depth / 2) * normal;
  return Manifold<Real>{normal, depth, {{point, depth, 0}}};
}
// [plain_sphere_plane]

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
