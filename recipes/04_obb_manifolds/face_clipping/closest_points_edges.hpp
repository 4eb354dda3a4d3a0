#pragma once

/// \file
/// \brief Where two edges that cross come closest.

#include "04_obb_manifolds/face_clipping/box_features.hpp"
#include "04_obb_manifolds/plain_box_box/box_preferences.hpp"

#include <algorithm>

namespace cookbook
{

// [midway_between]
/// How far [m] from A's middle an edge A comes closest to an edge B, both without ends; O13.
template <class Real>
Real closest_along(const BoxEdge<Real>& a, const BoxEdge<Real>& b)
{
  return closest_on_line<Real>(b.middle - a.middle, a.direction, b.direction);
}

/// The point of an edge at a distance [m] from its middle, or the end that comes before it.
template <class Real>
Vector3<Real> point_along(const BoxEdge<Real>& edge, const Real& distance)
{
  return edge.middle +
         std::clamp<Real>(distance, -edge.half_length, edge.half_length) * edge.direction;
}

/// The point of an edge closest to another point.
template <class Real>
Vector3<Real> point_near(const BoxEdge<Real>& edge, const Vector3<Real>& point)
{
  return point_along<Real>(edge, (point - edge.middle).dot(edge.direction));
}

/// The point midway between two edges that cross; O13.
///
/// Only rounding takes it past the end of an edge that gives the least overlap: then the ends, and
/// what is closest to them, stand in.
template <class Real>
Vector3<Real> midway_between(const BoxEdge<Real>& a, const BoxEdge<Real>& b)
{
  const Vector3<Real> near_a = point_along<Real>(a, closest_along(a, b));
  const Vector3<Real> on_b = point_near<Real>(b, near_a);
  const Vector3<Real> on_a = point_near<Real>(a, on_b);
  return (on_a + on_b) / Real(2);
}
// [midway_between]

} // namespace cookbook
