#pragma once

/// \file
/// \brief The AABB of an oriented box.

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

} // namespace cookbook
