#pragma once

/// \file
/// \brief The manifold of a sphere and the solid below a plane, as the formula stands.

#include "02_primitives/plain_points/plain_points.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <optional>

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

} // namespace cookbook
