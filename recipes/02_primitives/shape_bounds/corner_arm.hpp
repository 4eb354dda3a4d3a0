#pragma once

/// \file
/// \brief The corners of an oriented box.

#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

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
