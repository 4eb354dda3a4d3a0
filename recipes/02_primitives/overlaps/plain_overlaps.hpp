#pragma once

/// \file
/// \brief Whether boxes along the axes overlap: with each other, and with a sphere.

#include "02_primitives/shapes/more_shapes.hpp"
#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

/// Whether two boxes along the axes have a point in common; exact, and an empty box has none.
template <class Real>
bool boxes_overlap(const Aabb<Real>& a, const Aabb<Real>& b)
{
  const auto along = [&](int i) { return a.min()[i] <= b.max()[i] && b.min()[i] <= a.max()[i]; };
  return along(0) && along(1) && along(2) && !a.isEmpty() && !b.isEmpty();
}

/// Whether a sphere and a box along the axes have a point in common: the box's closest point to the
/// centre is within the radius.
///
/// For sizes whose squares fit the number type.
template <class Real>
bool sphere_overlaps_box(const Sphere<Real>& sphere, const Aabb<Real>& box)
{
  const Vector3<Real> closest = sphere.center.cwiseMax(box.min()).cwiseMin(box.max());
  return (sphere.center - closest).squaredNorm() <= sphere.radius * sphere.radius;
}

} // namespace cookbook
