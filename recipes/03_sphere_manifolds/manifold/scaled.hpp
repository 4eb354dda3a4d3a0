#pragma once

/// \file
/// \brief Boxes and manifolds made larger or smaller by powers of two, which is exact.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <cmath>

namespace cookbook
{

/// A vector times two to the power of `exponent`.
template <class Real>
Vector3<Real> scaled(const Vector3<Real>& v, int exponent)
{
  return v.unaryExpr([exponent](Real x) { return std::ldexp(x, exponent); });
}

/// A box times two to the power of `exponent`, seen from the origin.
template <class Real>
Obb<Real> scaled(const Obb<Real>& box, int exponent)
{
  return {scaled(box.center, exponent), box.axes, scaled(box.half_extents, exponent)};
}

/// A manifold times two to the power of `exponent`; lengths that do not fit become infinite.
template <class Real>
Manifold<Real> scaled(Manifold<Real> manifold, int exponent)
{
  manifold.depth = std::ldexp(manifold.depth, exponent);
  for (ContactPoint<Real>& point : manifold.points)
  {
    point.position = scaled(point.position, exponent);
    point.depth = std::ldexp(point.depth, exponent);
  }
  return manifold;
}

} // namespace cookbook
