#pragma once

/// \file
/// \brief How far a turned box reaches: along a direction, and along the world's axes.

#include "02_primitives/shapes/more_shapes.hpp"
#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

// [box_radius]
/// How far [m] a box reaches from its centre along a unit vector, half its shadow; P6.
template <class Real>
Real box_radius(const Obb<Real>& box, const Vector3<Real>& n)
{
  return box.half_extents.dot((box.axes.transpose() * n).cwiseAbs());
}

/// The box along the world's axes around a turned one; P7.
template <class Real>
Aabb<Real> bounds_of(const Obb<Real>& box)
{
  const Vector3<Real> half = box.axes.cwiseAbs() * box.half_extents;
  return Aabb<Real>(Vector3<Real>(box.center - half), Vector3<Real>(box.center + half));
}
// [box_radius]

} // namespace cookbook
