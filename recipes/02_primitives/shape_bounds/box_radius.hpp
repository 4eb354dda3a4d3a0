#pragma once

/// \file
/// \brief The projection of an oriented box on an axis.

#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

// [box_radius]
/// The projected radius [m] of a box: half its projection on a unit vector n; P6.
template <class Real>
Real box_radius(const Obb<Real>& box, const Vector3<Real>& n)
{
  const Vector3<Real> along = box.axes.transpose() * n;
  return box.half_extents.dot(along.cwiseAbs());
}
// [box_radius]

} // namespace cookbook
