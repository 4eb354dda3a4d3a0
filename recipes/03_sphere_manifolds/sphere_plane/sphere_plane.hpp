#pragma once

/// \file
/// \brief The manifold of a sphere and the solid below a plane.

#include "02_primitives/plain_points/plain_points.hpp"
#include "03_sphere_manifolds/manifold/any_size_spheres.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "common/math/wide.hpp"

namespace cookbook
{

// [sphere_plane]
/// The manifold of a sphere A and the half-space B below a plane, however deep the sphere is.
///
/// The normal points from the sphere into the solid. The distance is signed: a centre below the
/// surface makes the depth larger than the radius. Touching is contact of depth zero.
template <class Real>
std::optional<Manifold<Real>> sphere_plane(const Sphere<Real>& sphere, const Plane<Real>& plane)
{
  const auto find = [](const Sphere<Real>& a, const Plane<Real>& b)
  {
    const Plane<Wide<Real>> wide{widen(b.normal), b.distance};
    const Real distance = static_cast<Real>(signed_distance<Wide<Real>>(wide, widen(a.center)));
    const Direction<Real> to_surface{-b.normal, distance};
    return overlap_manifold(sphere_overlap(to_surface, a.radius, Real(0)), a.center);
  };
  return at_any_size(sphere, plane, sums_fit<Real>, find);
}
// [sphere_plane]

} // namespace cookbook
