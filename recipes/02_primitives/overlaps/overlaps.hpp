#pragma once

/// \file
/// \brief Whether any two shapes overlap; touching counts.

#include "02_primitives/closest_points/closest_points.hpp"

namespace cookbook
{

// [overlaps]
/// Whether two shapes have a point in common, to rounding.
template <BoundedShape A, BoundedShape B>
bool overlaps(const A& a, const B& b)
{
  using Real = NumberOf<A>;
  const PairFrame<Wide<Real>> frame = pair_frame<Real>(a, b);
  return closest_on_hulls(rounded_hull(a, frame), rounded_hull(b, frame)).distance == Wide<Real>(0);
}

/// Whether a half-space and a shape have.
template <class Real, BoundedShape Shape>
bool overlaps(const Plane<Real>& plane, const Shape& shape)
{
  return closest_points(plane, shape).distance == Real(0);
}

/// The same in the other order.
template <BoundedShape Shape, class Real>
bool overlaps(const Shape& shape, const Plane<Real>& plane)
{
  return overlaps(plane, shape);
}

/// Whether two half-spaces have.
template <class Real>
bool overlaps(const Plane<Real>& a, const Plane<Real>& b)
{
  return closest_points(a, b).distance == Real(0);
}
// [overlaps]

} // namespace cookbook
