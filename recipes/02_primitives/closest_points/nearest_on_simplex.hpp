#pragma once

/// \file
/// \brief The point of a tetrahedron, or of what is less, that is closest to the origin.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"

#include <algorithm>
#include <limits>

namespace cookbook
{

// [nearest_on_simplex]
/// The point of a tetrahedron that is closest to the origin: the origin itself where it is inside,
/// or the closest point of the four faces.
template <class Real>
Nearest<Real> nearest_on_tetrahedron(const Vector3<Real>* corners)
{
  const Vector3<Real>&a = corners[0], &b = corners[1], &c = corners[2], &d = corners[3];
  const Vector3<Real> b_c = b.cross(c), a_d = a.cross(d);
  // Six times the volume between the origin and the face across from each corner, and of it all.
  const Vector<Real, 4> volumes(d.dot(b_c), c.dot(a_d), -b.dot(a_d), -a.dot(b_c));
  const Real whole = volumes.sum();
  const Vector<Real, 4> weights = volumes / whole;
  const bool inside = whole != Real(0) && weights.minCoeff() > Real(0);
  Nearest<Real> nearest{weights, weights[0] * a + weights[1] * b + weights[2] * c + weights[3] * d};
  const Real rounding = Real(8) * std::numeric_limits<Real>::epsilon();
  const Real size = std::max(std::max(a.squaredNorm(), b.squaredNorm()), d.squaredNorm());
  // A flat tetrahedron has nothing inside but rounding: its faces decide.
  if (inside && nearest.point.squaredNorm() <= rounding * rounding * size)
  {
    return nearest;
  }
  Nearest<Real> face = nearest_on_triangle(corners, 0, 1, 2);
  face = closer_of(face, nearest_on_triangle(corners, 0, 1, 3));
  face = closer_of(face, nearest_on_triangle(corners, 0, 2, 3));
  face = closer_of(face, nearest_on_triangle(corners, 1, 2, 3));
  return inside ? closer_of(face, nearest) : face;
}

/// The point of the simplex of the first `size` corners that is closest to the origin.
template <class Real>
Nearest<Real> nearest_on_simplex(const Vector3<Real>* corners, int size)
{
  switch (size)
  {
  case 1:
    return {Vector<Real, 4>::UnitX(), corners[0]};
  case 2:
    return nearest_on_segment(corners, 0, 1);
  case 3:
    return nearest_on_triangle(corners, 0, 1, 2);
  default:
    return nearest_on_tetrahedron(corners);
  }
}
// [nearest_on_simplex]

} // namespace cookbook
