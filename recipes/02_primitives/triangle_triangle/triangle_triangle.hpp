#pragma once

/// \file
/// \brief Whether two triangles meet: by separating axes, and without an error.

#include "02_primitives/shapes/shapes.hpp"
#include "02_primitives/triangle_triangle/exact_sign.hpp"

#include <algorithm>
#include <array>

namespace cookbook
{

/// The corners of a triangle.
template <class Real>
std::array<Vector3<Real>, 3> corners_of(const Triangle<Real>& triangle)
{
  return {triangle.a, triangle.b, triangle.c};
}

/// The edges of a triangle, each from one corner to the next.
template <class Real>
std::array<Vector3<Real>, 3> edges_of(const Triangle<Real>& t)
{
  return {Vector3<Real>(t.b - t.a), Vector3<Real>(t.c - t.b), Vector3<Real>(t.a - t.c)};
}

/// Whether the projections of two triangles on an axis have a gap between them.
template <class Real>
bool separates_triangles(
    const Vector3<Real>& axis, const Triangle<Real>& a, const Triangle<Real>& b)
{
  const Real a0 = axis.dot(a.a), a1 = axis.dot(a.b), a2 = axis.dot(a.c);
  const Real b0 = axis.dot(b.a), b1 = axis.dot(b.b), b2 = axis.dot(b.c);
  using std::min, std::max;
  return max(max(a0, a1), a2) < min(min(b0, b1), b2) || max(max(b0, b1), b2) < min(min(a0, a1), a2);
}

/// Two normals, and each edge of one across each edge of the other: not enough for triangles in
/// one plane, where all of these are the normal, or zero.
template <class Real>
bool triangles_meet_by_11_axes(const Triangle<Real>& a, const Triangle<Real>& b)
{
  const std::array<Vector3<Real>, 3> edges_a = edges_of(a), edges_b = edges_of(b);
  bool separated = separates_triangles<Real>(edges_a[0].cross(edges_a[1]), a, b) ||
                   separates_triangles<Real>(edges_b[0].cross(edges_b[1]), a, b);
  for (const Vector3<Real>& one : edges_a)
  {
    for (const Vector3<Real>& other : edges_b)
    {
      separated = separated || separates_triangles<Real>(one.cross(other), a, b);
    }
  }
  return !separated;
}

// [seventeen_axes]
/// And each edge across its own triangle's normal: the axes of the plane; P17.
template <class Real>
bool triangles_meet_by_17_axes(const Triangle<Real>& a, const Triangle<Real>& b)
{
  bool meet = triangles_meet_by_11_axes<Real>(a, b);
  for (const Triangle<Real>* t : {&a, &b})
  {
    const std::array<Vector3<Real>, 3> edges = edges_of(*t);
    const Vector3<Real> normal = edges[0].cross(edges[1]);
    for (const Vector3<Real>& edge : edges)
    {
      meet = meet && !separates_triangles<Real>(edge.cross(normal), a, b);
    }
  }
  return meet;
}
// [seventeen_axes]

} // namespace cookbook
