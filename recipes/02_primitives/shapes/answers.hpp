#pragma once

/// \file
/// \brief What is answered about two shapes, in the plane and in space.

#include "common/math/vector.hpp"

namespace cookbook
{

// [answers]
/// A point of each of two shapes, none closer to each other; the same point where they overlap.
template <class Real, int Size>
struct ClosestPoints
{
  Vector<Real, Size> a; ///< [m], of the first shape
  Vector<Real, Size> b; ///< [m], of the second shape
  Real distance;        ///< [m], between them; 0 where the shapes touch or overlap
};

/// Where a ray or a segment first meets a shape.
template <class Real, int Size>
struct Hit
{
  Real t;                    ///< [1], the point is origin + t direction, or start + t (end - start)
  Vector<Real, Size> point;  ///< [m]
  Vector<Real, Size> normal; ///< [1], unit, out of the shape; from inside, against the ray
};
// [answers]

} // namespace cookbook
