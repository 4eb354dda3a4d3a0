#pragma once

/// \file
/// \brief The point of a triangle that is closest to a point, for triangles of every form.

#include "02_primitives/closest_point_triangle/nearest_by_region.hpp"
#include "common/math/wide.hpp"

namespace cookbook
{

// [vector_to_triangle]
/// The point of a triangle closest to another point, seen from there. Sizes from 1e-70 to 1e70 in
/// double.
template <class Real>
[[gnu::flatten]] Nearest<Wide<Real>>
nearest_from(const Vector3<Wide<Real>>& point, const Triangle<Real>& triangle)
{
  return nearest_by_region<Wide<Real>>(
      widen(triangle.a) - point, widen(triangle.b) - point, widen(triangle.c) - point);
}

/// The way from a point to the closest point of a triangle: right also where it is short.
template <class Real>
Vector3<Wide<Real>>
vector_to_triangle(const Triangle<Real>& triangle, const Vector3<Wide<Real>>& point)
{
  return nearest_from<Real>(point, triangle).point;
}

/// The point of a triangle that is closest to a point: in the triangle also where that is thin.
template <class Real>
Vector3<Real> closest_point_of_triangle(const Triangle<Real>& triangle, const Vector3<Real>& point)
{
  const auto weights = nearest_from<Real>(widen(point), triangle).weights;
  const Vector3<Wide<Real>> closest = weights[0] * widen(triangle.a) +
                                      weights[1] * widen(triangle.b) +
                                      weights[2] * widen(triangle.c);
  return closest.template cast<Real>();
}
// [vector_to_triangle]

} // namespace cookbook
