#pragma once

/// \file
/// \brief Whether spheres and boxes overlap: the formulas as they stand, for a room.

#include "02_primitives/shape_bounds/box_radius.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [spheres_overlap]
/// Whether two spheres have a point in common; touching counts, here and below.
template <class Real>
bool spheres_overlap(const Sphere<Real>& a, const Sphere<Real>& b)
{
  const Real radii = a.radius + b.radius;
  return (b.center - a.center).squaredNorm() <= radii * radii;
}

/// Whether two boxes along the axes have; neither may be empty.
template <class Real>
bool aabbs_overlap(const Aabb<Real>& a, const Aabb<Real>& b)
{
  const bool before_b_ends = (a.min().array() <= b.max().array()).all();
  return before_b_ends && (b.min().array() <= a.max().array()).all();
}

/// Whether a sphere and a box along the axes have.
template <class Real>
bool sphere_aabb_overlap(const Sphere<Real>& sphere, const Aabb<Real>& box)
{
  const Vector3<Real> closest = sphere.center.cwiseMax(box.min()).cwiseMin(box.max());
  return (closest - sphere.center).squaredNorm() <= sphere.radius * sphere.radius;
}
// [spheres_overlap]

// [obbs_overlap]
/// Whether two oriented boxes have: the separating axis test, with 3 + 3 + 9 axes.
template <class Real>
bool obbs_overlap(const Obb<Real>& a, const Obb<Real>& b)
{
  const auto separates = [&](const Vector3<Real>& n)
  { return std::abs(n.dot(b.center - a.center)) > box_radius(a, n) + box_radius(b, n); };
  for (int i = 0; i < 3; ++i)
  {
    if (separates(a.axes.col(i)) || separates(b.axes.col(i)))
    {
      return false;
    }
    for (int j = 0; j < 3; ++j)
    {
      if (separates(a.axes.col(i).cross(b.axes.col(j))))
      {
        return false;
      }
    }
  }
  return true;
}
// [obbs_overlap]

// [sphere_around]
/// A sphere around points [m], of which there is at least one: about the centre of their box.
template <class Real>
Sphere<Real> sphere_around(const std::vector<Vector3<Real>>& points)
{
  Aabb<Real> box;
  for (const Vector3<Real>& p : points)
  {
    box.extend(p);
  }
  Sphere<Real> sphere{box.center(), Real(0)};
  for (const Vector3<Real>& p : points)
  {
    sphere.radius = std::max(sphere.radius, Real((p - sphere.center).norm()));
  }
  return sphere;
}
// [sphere_around]

} // namespace cookbook
