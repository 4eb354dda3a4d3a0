#pragma once

/// \file
/// \brief The point of a triangle that is closest to a point, for triangles of every form.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/wide.hpp"

namespace cookbook
{

// [toward_edge]
/// The way from a point to the closest point of an edge: `start` is the way to its start.
template <class W>
Vector3<W> toward_edge(const Vector3<W>& start, const Vector3<W>& edge)
{
  const W squared = edge.squaredNorm(), share = -start.dot(edge);
  if (!(share > W(0)) || !(squared > W(0)))
  {
    return start;
  }
  return share < squared ? Vector3<W>(start + share / squared * edge) : Vector3<W>(start + edge);
}

/// The shorter of two ways.
template <class W>
Vector3<W> shorter_way(const Vector3<W>& one, const Vector3<W>& other)
{
  return other.squaredNorm() < one.squaredNorm() ? other : one;
}
// [toward_edge]

// [toward_triangle]
/// The way from a point to the closest point of a triangle, given the ways to its corners; a flat
/// triangle is its edges. Sizes from 1e-70 to 1e70 in double.
template <class W>
Vector3<W> toward_triangle(const Vector3<W>& a, const Vector3<W>& b, const Vector3<W>& c)
{
  const Vector3<W> ab = b - a, ac = c - a, normal = ab.cross(ac);
  const W whole = normal.squaredNorm();
  // The parts of the area across from b and c, seen along the normal.
  const W of_b = normal.dot(ac.cross(a)), of_c = normal.dot(a.cross(ab));
  const bool over_face = whole > W(0) && of_b >= W(0) && of_c >= W(0) && of_b + of_c <= whole;
  const Vector3<W> edges = shorter_way<W>(
      shorter_way<W>(toward_edge<W>(a, ab), toward_edge<W>(a, ac)), toward_edge<W>(b, c - b));
  return over_face ? shorter_way<W>(a + of_b / whole * ab + of_c / whole * ac, edges) : edges;
}
// [toward_triangle]

// [closest_point_of_triangle]
/// The point of a triangle that is closest to a point.
template <class Real>
Vector3<Real> closest_point_of_triangle(const Triangle<Real>& triangle, const Vector3<Real>& point)
{
  using V = Vector3<Wide<Real>>;
  const V p = widen(point);
  const V way = toward_triangle<Wide<Real>>(
      widen(triangle.a) - p, widen(triangle.b) - p, widen(triangle.c) - p);
  return V(p + way).template cast<Real>();
}
// [closest_point_of_triangle]

} // namespace cookbook
