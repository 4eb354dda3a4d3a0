#pragma once

/// \file
/// \brief When a sphere that is moved first touches any shape.

#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "06_world/shapes/gap_between.hpp"

#include <optional>

namespace cookbook
{

/// The first touch of a sphere that is moved by a displacement [m], world.
inline std::optional<SweptHit<double>>
sweep(const Sphere<double>& sphere, const Vector3<double>& displacement, const Obb<double>& box)
{
  return swept_sphere_box(sphere, displacement, box);
}
inline std::optional<SweptHit<double>>
sweep(const Sphere<double>& sphere, const Vector3<double>& displacement, const Plane<double>& plane)
{
  return swept_sphere_plane(sphere, displacement, plane);
}
inline std::optional<SweptHit<double>> sweep(
    const Sphere<double>& sphere, const Vector3<double>& displacement, const Sphere<double>& other)
{
  return swept_sphere_sphere(sphere, displacement, other);
}
inline std::optional<SweptHit<double>> sweep(
    const Sphere<double>& sphere, const Vector3<double>& displacement,
    const Placed<ConvexShape>& other)
{
  const double rounding = sweep_rounding<double>(
      other.pose.center - sphere.center, displacement, extent(other.shape).outer + sphere.radius);
  const auto gap = [&](const Vector3<double>& offset) {
    return gap_of(Sphere<double>{sphere.center + offset, sphere.radius}, other);
  };
  return first_touch<double>(displacement, rounding, gap);
}

} // namespace cookbook
