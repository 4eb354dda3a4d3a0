#pragma once

/// \file
/// \brief Where a ray first meets a plane, a sphere, a box and a triangle: t, as the formulas
/// stand.

#include "02_primitives/shapes/more_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

// [ray_plane]
/// The t at which a ray that sinks towards a plane meets it; P8.
template <class Real>
std::optional<Real> ray_plane(const Ray<Real>& ray, const Plane<Real>& plane)
{
  const Real height = plane.normal.dot(ray.origin) - plane.distance;
  const Real sinking = -plane.normal.dot(ray.direction);
  return sinking > Real(0) && height >= Real(0) ? std::optional(height / sinking) : std::nullopt;
}
// [ray_plane]

// [ray_sphere]
/// The t at which a ray that starts outside a sphere meets it; P9.
template <class Real>
std::optional<Real> ray_sphere(const Ray<Real>& ray, const Sphere<Real>& sphere)
{
  const Vector3<Real> v = ray.direction, f = sphere.center - ray.origin;
  const Vector3<Real> l = f.dot(v) / v.squaredNorm() * v - f;
  const Real under_root = v.squaredNorm() * (sphere.radius * sphere.radius - l.squaredNorm());
  if (f.dot(v) < Real(0) || under_root < Real(0))
  {
    return std::nullopt; // the sphere is behind the ray, or beside it
  }
  const Real q = f.dot(v) + std::sqrt(under_root);
  const Real outside = f.squaredNorm() - sphere.radius * sphere.radius;
  return q > Real(0) ? outside / q : Real(0); // zero: it starts where it touches
}
// [ray_sphere]

// [ray_box]
/// The t at which a ray enters a box along the axes, 0 from inside: the slab test, P10.
template <class Real>
std::optional<Real> ray_box(const Ray<Real>& ray, const Aabb<Real>& box)
{
  const Vector3<Real> one = (box.min() - ray.origin).cwiseQuotient(ray.direction);
  const Vector3<Real> other = (box.max() - ray.origin).cwiseQuotient(ray.direction);
  const Real enter = one.cwiseMin(other).maxCoeff();
  const Real leave = one.cwiseMax(other).minCoeff();
  return enter <= leave && leave >= Real(0) ? std::optional(std::max(enter, Real(0)))
                                            : std::nullopt;
}
// [ray_box]

// [ray_triangle]
/// The t at which a ray meets a triangle, from either side: Möller and Trumbore's way, P12.
template <class Real>
std::optional<Real> ray_triangle(const Ray<Real>& ray, const Triangle<Real>& triangle)
{
  const Vector3<Real> e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
  const Vector3<Real> s = ray.origin - triangle.a;
  const Vector3<Real> m = ray.direction.cross(e2), k = s.cross(e1);
  const Real determinant = e1.dot(m); // zero if the ray is parallel to the triangle
  const Real t = e2.dot(k) / determinant;
  const Real u = s.dot(m) / determinant, w = ray.direction.dot(k) / determinant;
  const bool meets = u >= Real(0) && w >= Real(0) && u + w <= Real(1) && t >= Real(0);
  return meets && determinant != Real(0) ? std::optional(t) : std::nullopt;
}
// [ray_triangle]

} // namespace cookbook
