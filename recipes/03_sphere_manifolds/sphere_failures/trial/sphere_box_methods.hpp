#pragma once

/// \file
/// \brief Competing methods for the manifold of a sphere and a box, each named after its idea.

#include "02_primitives/closest_point_box/trial/closest_point_box_pitfalls.hpp"
#include "03_sphere_manifolds/plain_spheres/plain_spheres.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace cookbook
{

/// What the code published beside the seed book computes, in our own words; X05, X06, X07.
///
/// A squared distance below float's epsilon is taken for a centre inside the box, a third of a
/// millimetre early. Inside, the normal points to the box's centre instead of through the nearest
/// face, and the depth is the radius, however deep the sphere is. A sphere in the very centre
/// counts as apart.
inline std::optional<Manifold<float>>
sphere_box_as_published(const Sphere<float>& sphere, const Obb<float>& box)
{
  constexpr float epsilon = std::numeric_limits<float>::epsilon();
  const Vector3<float> to_closest = closest_point(box, sphere.center) - sphere.center;
  const float distance = to_closest.norm();
  if (distance > sphere.radius)
  {
    return std::nullopt;
  }
  Vector3<float> normal = to_closest;
  if (to_closest.squaredNorm() <= epsilon)
  {
    normal = box.center - sphere.center;
    if (normal.squaredNorm() <= epsilon)
    {
      return std::nullopt;
    }
  }
  const float depth = sphere.radius - distance;
  normal /= normal.norm();
  const Vector3<float> point = sphere.center + normal * (sphere.radius - depth / 2);
  return Manifold<float>{normal, depth, {{point, depth, 0}}};
}

/// The formula for the outside, given the way to the closest point: where that has no length, zero
/// is divided by zero.
inline std::optional<Manifold<float>>
outside_manifold(const Sphere<float>& sphere, const Vector3<float>& to_closest)
{
  const float distance = to_closest.norm();
  const float depth = sphere.radius - distance;
  if (depth < 0)
  {
    return std::nullopt;
  }
  const Vector3<float> normal = to_closest / distance;
  const Vector3<float> point = sphere.center + normal * (sphere.radius - depth / 2);
  return Manifold<float>{normal, depth, {{point, depth, 0}}};
}

/// The formula for the outside, used everywhere: inside, the closest point is the centre itself.
inline std::optional<Manifold<float>>
sphere_box_outside_only(const Sphere<float>& sphere, const Obb<float>& box)
{
  return outside_manifold(sphere, closest_point(box, sphere.center) - sphere.center);
}

/// The formula for the outside with the closest point as published for upright boxes, in our own
/// words: y and z are compared with the bounds of x; X28. The box's axes are not looked at.
inline std::optional<Manifold<float>>
sphere_box_mixed_bounds(const Sphere<float>& sphere, const Obb<float>& box)
{
  const Vector3<float> local = sphere.center - box.center;
  return outside_manifold(sphere, clamp_mixed_bounds<float>(local, box.half_extents) - local);
}

} // namespace cookbook
