#pragma once

/// \file
/// \brief The AABB of an oriented box, and its corners.

#include "02_primitives/shape_bounds/box_radius.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

namespace cookbook
{

// [bounds_of]
/// The axis-aligned bounding box (AABB) of an oriented box; P7.
template <class Real>
Aabb<Real> bounds_of(const Obb<Real>& box)
{
  const Vector3<Real> half = box.axes.cwiseAbs() * box.half_extents;
  return Aabb<Real>(Vector3<Real>(box.center - half), Vector3<Real>(box.center + half));
}
// [bounds_of]

/// The arm [m], world, from a box's centre to one of its corners, 0 to 7: the bits of the number
/// say on which side of each axis it lies.
template <class Real>
Vector3<Real> corner_arm(const Obb<Real>& box, unsigned corner)
{
  const Vector3<Real> sides(
      corner & 1U ? Real(1) : Real(-1), corner & 2U ? Real(1) : Real(-1),
      corner & 4U ? Real(1) : Real(-1));
  return box.axes * box.half_extents.cwiseProduct(sides);
}

} // namespace cookbook
