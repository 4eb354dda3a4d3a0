#pragma once

/// \file
/// \brief The manifold of two boxes: one face cut out by another, or two edges that cross.

#include "03_sphere_manifolds/manifold/any_size.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"
#include "04_obb_manifolds/face_clipping/boxes_in_frame_of_a.hpp"
#include "04_obb_manifolds/face_clipping/clipped_face.hpp"
#include "04_obb_manifolds/face_clipping/closest_points_edges.hpp"

#include <cstdint>
#include <optional>

namespace cookbook
{

// [crossing_feature]
/// The feature of the point where two edges cross as seen along the normal: 1 … 576.
///
/// Two edges of A meet in a corner of A, two of B in one of B. The order is that of the sides of
/// the polygon, counter-clockwise as seen from B: the same whichever box has the reference face.
inline std::uint32_t crossing_feature(int before, int after)
{
  return static_cast<std::uint32_t>(1 + 2 * box_edges * before + after);
}
// [crossing_feature]

// [face_points]
/// The contact point of a corner over the reference face: midway, as deep as it is there; O12.
template <class Real>
ContactPoint<Real>
face_point(const BoxFace<Real>& reference, const Vector3<Real>& over_face, std::uint32_t feature)
{
  const Vector3<Real> midway(over_face.x(), over_face.y(), over_face.z() / Real(2));
  return {reference.center + reference.axes * midway, Real(0) - over_face.z(), feature};
}

/// The points of two boxes that meet at a face: O10, O11, O12.
///
/// One for each corner of the incident face's part over the reference face, unless there is a gap
/// wider than `widest_separation` at it.
template <class Real>
ContactPoints<Real, 8> face_points(const BoxesInFrameOfA<Real>& boxes)
{
  const bool of_a = axis_kind(boxes.least.axis) == AxisKind::face_of_a;
  const BoxFace<Real> of_box_a = face_along<Real>(boxes.a, boxes.least.normal);
  const BoxFace<Real> of_box_b = face_along<Real>(boxes.b, -boxes.least.normal);
  const BoxFace<Real>&reference = of_a ? of_box_a : of_box_b,
        &incident = of_a ? of_box_b : of_box_a;
  const FacePolygon<Real> polygon = overlap_polygon(reference, incident, boxes.tolerance);
  ContactPoints<Real, 8> points;
  for (int i = 0; i < polygon.size; ++i)
  {
    const int before = polygon[of_a ? i - 1 : i].edge, after = polygon[of_a ? i : i - 1].edge;
    if (polygon[i].point.z() <= boxes.widest_separation)
    {
      points.push_back(face_point(reference, polygon[i].point, crossing_feature(before, after)));
    }
  }
  if (points.empty())
  {
    const PolygonCorner<Real> deepest = deepest_over(reference, incident);
    points.push_back(
        face_point(reference, deepest.point, crossing_feature(deepest.edge, deepest.edge)));
  }
  return points;
}
// [face_points]

// [edge_point]
/// The point of two boxes that meet at a pair of edges.
template <class Real>
ContactPoint<Real> edge_point(const BoxesInFrameOfA<Real>& boxes)
{
  const int i = (boxes.least.axis - 6) / 3, j = (boxes.least.axis - 6) % 3;
  const BoxEdge<Real> of_a = edge_along<Real>(boxes.a, i, boxes.least.normal);
  const BoxEdge<Real> of_b = edge_along<Real>(boxes.b, j, -boxes.least.normal);
  return {
      midway_between(of_a, of_b), boxes.least.depth, crossing_feature(of_a.number, of_b.number)};
}
// [edge_point]

// [face_clipping]
/// The least overlap; of a face, where edges win by no more than rounding.
///
/// Such edges lie in a face of one box, and which of them it is that meets the other's is chance.
template <class Real>
std::optional<LeastOverlap<Real>> least_with_certain_edges(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::optional<LeastOverlap<Real>> least = separating_axes(a, b);
  if (!least || axis_kind(least->axis) != AxisKind::edges)
  {
    return least;
  }
  const std::optional<LeastOverlap<Real>> of_faces = least_overlap(a, b, 6);
  const Real tolerance = rounding_tolerance(relative_boxes(a, b));
  return of_faces->depth <= least->depth + tolerance ? of_faces : least;
}

/// The manifold of two boxes of ordinary size; see face_clipping().
template <class Real>
std::optional<Manifold<Real>> face_clipping_of(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::optional<LeastOverlap<Real>> least = least_with_certain_edges(a, b);
  if (!least)
  {
    return std::nullopt;
  }
  const BoxesInFrameOfA<Real> boxes = boxes_in_frame_of_a(a, b, *least);
  Manifold<Real> manifold{least->normal, least->depth, {}};
  manifold.points = axis_kind(least->axis) == AxisKind::edges
                        ? ContactPoints<Real, 8>(edge_point(boxes))
                        : face_points(boxes);
  for (ContactPoint<Real>& point : manifold.points)
  {
    point.position = a.center + a.axes * point.position;
  }
  return manifold;
}

/// The manifold of two boxes: the least overlap, and all points where they press on each other.
///
/// Where a face has the least overlap, the points are the corners of what lies over it of the other
/// box's face, each with its own depth; one whose depth is negative has a gap no wider than a
/// hundredth of the smaller box and than the depth. Where a pair of edges has it, the point is the
/// one midway between the two. One to eight points, each within half the depth of both boxes;
/// features as crossing_feature() numbers them. What separating_axes() says of touching and of ties
/// holds here too, and a face wins where edges are better by rounding_tolerance() only. Boxes may
/// be of any finite size.
template <class Real>
std::optional<Manifold<Real>> face_clipping(const Obb<Real>& a, const Obb<Real>& b)
{
  return at_any_size(a, b, sums_fit<Real>, face_clipping_of<Real>);
}
// [face_clipping]

} // namespace cookbook
