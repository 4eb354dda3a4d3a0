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
