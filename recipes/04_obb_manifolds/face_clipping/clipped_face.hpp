#pragma once

/// \file
/// \brief The part of one face that lies over another: a polygon, cut out side by side.

#include "04_obb_manifolds/face_clipping/box_features.hpp"
#include "04_obb_manifolds/plain_box_box/box_preferences.hpp"
#include "04_obb_manifolds/separating_axes/side_of_face.hpp"

#include <algorithm>
#include <array>

namespace cookbook
{

// [face_polygon]
/// A corner of a polygon, and the edge of a box that leads from it to the next.
template <class Real>
struct PolygonCorner
{
  Vector3<Real> point; ///< [m], in the reference face's axes, from its centre: z is above it
  int edge;            ///< 0 … 11 of A, 12 … 23 of B
};

/// A convex polygon over a face; four sides cut at four lines have at most eight corners.
template <class Real, int Capacity = 8>
struct FacePolygon
{
  std::array<PolygonCorner<Real>, std::size_t(Capacity)> corners; ///< the first `size`
  int size = 0;                                                   ///< how many there are

  /// Adds a corner. One too many can only come from rounding, is then close to another, and left
  /// out.
  void add(const PolygonCorner<Real>& corner)
  {
    if (size < Capacity)
    {
      corners[static_cast<std::size_t>(size++)] = corner;
    }
  }

  /// Corner i; they are counted round and round.
  const PolygonCorner<Real>& operator[](int i) const
  {
    return corners[static_cast<std::size_t>((i + size) % size)];
  }
};
// [face_polygon]

// [seen_from]
/// The incident face in the axes of the reference face.
template <class Real>
FacePolygon<Real> seen_from(const BoxFace<Real>& reference, const BoxFace<Real>& incident)
{
  const Matrix3<Real> turn = reference.axes.transpose() * incident.axes;
  const Vector3<Real> center = reference.axes.transpose() * (incident.center - reference.center);
  const Vector3<Real> x = incident.half_sides.x() * turn.col(0);
  const Vector3<Real> y = incident.half_sides.y() * turn.col(1);
  FacePolygon<Real> polygon;
  polygon.add({center - x - y, incident.edges[0]});
  polygon.add({center + x - y, incident.edges[1]});
  polygon.add({center + x + y, incident.edges[2]});
  polygon.add({center - x + y, incident.edges[3]});
  return polygon;
}
// [seen_from]

// [cut_at_side]
/// The part of a polygon on the inner side of a line, beyond which `distance(corner)` [m] is above
/// zero; Sutherland and Hodgman, O11. What runs along the line becomes the edge `edge`.
///
/// A corner within `tolerance` [m] of the line is on it, and stays as it is. A polygon of two
/// corners is a segment: it is cut on the way there, not again on the way back.
template <class Real, int Capacity, class Distance>
FacePolygon<Real, Capacity> cut_at_line(
    const FacePolygon<Real, Capacity>& polygon, const Distance& distance, int edge, Real tolerance)
{
  FacePolygon<Real, Capacity> inside;
  for (int i = 0; i < polygon.size; ++i)
  {
    const PolygonCorner<Real>&a = polygon[i], &b = polygon[i + 1];
    const Real d_a = distance(a), d_b = distance(b);
    const int side_a = side_of_face(d_a, tolerance), side_b = side_of_face(d_b, tolerance);
    if (side_a <= 0)
    {
      inside.add({a.point, side_a == 0 && side_b > 0 ? edge : a.edge});
    }
    if (side_a * side_b < 0 && !(polygon.size == 2 && i == 1))
    {
      inside.add({point_at_plane(a.point, b.point, d_a, d_b), side_a < 0 ? edge : a.edge});
    }
  }
  return inside;
}

/// The part of a polygon within side 0 … 3 of the reference face.
template <class Real>
FacePolygon<Real> cut_at_side(
    const FacePolygon<Real>& polygon, const BoxFace<Real>& reference, int side, Real tolerance)
{
  const int k = side % 2 == 0 ? 1 : 0;
  const Real sign = side == 1 || side == 2 ? Real(1) : Real(-1);
  const auto distance = [&](const PolygonCorner<Real>& corner) -> Real
  { return sign * corner.point[k] - reference.half_sides[k]; };
  return cut_at_line(polygon, distance, reference.edges[static_cast<std::size_t>(side)], tolerance);
}
// [cut_at_side]

// [overlap_polygon]
/// The part of the incident face that lies over the reference face: none to eight corners; O14.
template <class Real>
FacePolygon<Real>
overlap_polygon(const BoxFace<Real>& reference, const BoxFace<Real>& incident, Real tolerance)
{
  FacePolygon<Real> polygon = seen_from(reference, incident);
  for (int side = 0; side < 4; ++side)
  {
    polygon = cut_at_side(polygon, reference, side, tolerance);
  }
  return polygon;
}
// [overlap_polygon]

// [deepest_over]
/// The incident face's deepest corner, moved over the reference face: for a face which rounding
/// left beside it.
template <class Real>
PolygonCorner<Real> deepest_over(const BoxFace<Real>& reference, const BoxFace<Real>& incident)
{
  const FacePolygon<Real> polygon = seen_from(reference, incident);
  PolygonCorner<Real> deepest = polygon[0];
  for (int i = 1; i < polygon.size; ++i)
  {
    deepest = polygon[i].point.z() < deepest.point.z() ? polygon[i] : deepest;
  }
  for (const int k : {0, 1})
  {
    deepest.point[k] =
        std::clamp<Real>(deepest.point[k], -reference.half_sides[k], reference.half_sides[k]);
  }
  return deepest;
}
// [deepest_over]

} // namespace cookbook
