#pragma once

/// \file
/// \brief A sphere as the shape of a body: its six functions.

#include "02_primitives/casts/casts.hpp"
#include "06_world/shapes/shape.hpp"

namespace cookbook
{

// [sphere_shape]
/// A sphere at a place.
inline Sphere<double> placed(const Pose& pose, const SphereShape& sphere)
{
  return {pose.center, sphere.radius};
}

/// The bounds of a sphere at a place.
inline Eigen::AlignedBox<double, 3> bounds(const SphereShape& sphere, const Pose& pose)
{
  const Vector3<double> reach = Vector3<double>::Constant(sphere.radius);
  return {pose.center - reach, pose.center + reach};
}

/// The point of a sphere farthest along a direction; of a zero one, the highest.
inline Vector3<double> support(const SphereShape& sphere, const Vector3<double>& direction)
{
  return sphere.radius * normalize<double>(direction).unit;
}

/// The mass and moments of a sphere of even density.
inline MassProperties<double> mass_properties(const SphereShape& sphere, double mass)
{
  return solid_sphere<double>(mass, sphere.radius);
}

/// How far a sphere reaches.
inline Extent extent(const SphereShape& sphere)
{
  return {sphere.radius, sphere.radius};
}

/// The direction out of a sphere at a point [m], and how far that is from its surface [m].
inline Direction<double> distance(const SphereShape& sphere, const Vector3<double>& point)
{
  const Direction<double> out = normalize<double>(point);
  return {out.unit, out.length - sphere.radius};
}

/// Where a ray meets a sphere.
inline ShapeHit cast(const Ray<double>& ray, const SphereShape& sphere)
{
  return cast(ray, Sphere<double>{Vector3<double>::Zero(), sphere.radius});
}
// [sphere_shape]

} // namespace cookbook
