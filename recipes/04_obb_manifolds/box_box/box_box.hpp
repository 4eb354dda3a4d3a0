#pragma once

/// \file
/// \brief The manifold of two oriented boxes: the chapter's answer.

#include "03_sphere_manifolds/manifold/scaled.hpp"
#include "03_sphere_manifolds/manifold/translated.hpp"
#include "04_obb_manifolds/box_box/box_manifold.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [box_choice]
/// What the manifold of two boxes is built on: the edges, if they were found, or the face.
template <class Real>
struct BoxChoice
{
  LeastFace<Real> face;
  LeastEdge<Real> edge;
};

/// The choice for two boxes whose squares fit; nothing where they are apart.
template <class Row, class Real>
std::optional<BoxChoice<Real>>
box_choice(const BoxesInRows<Row>& boxes, const Tolerances<Real>& tolerances)
{
  const Row face_a = face_overlaps(boxes.half_a, boxes.columns, boxes.half_b, boxes.offset_a);
  const Row face_b = face_overlaps(boxes.half_b, boxes.rows, boxes.half_a, boxes.offset_b);
  if (!((Row(0) <= face_a) & (Row(0) <= face_b)).all()) // boxes too far apart for numbers are NaN
  {
    return std::nullopt;
  }
  const EdgeOverlaps<Row> edges[] = {
      edge_overlaps(boxes, 0), edge_overlaps(boxes, 1), edge_overlaps(boxes, 2)};
  if ((min(min(edges[0].overlap, edges[1].overlap), edges[2].overlap) < Row(0)).any())
  {
    return std::nullopt;
  }
  const LeastFace<Real> face = least_face(face_a, face_b);
  return BoxChoice<Real>{face, least_edge(edges, edge_threshold(boxes, face.depth, tolerances))};
}
// [box_choice]

// [box_manifold]
/// The manifold of two boxes whose squares fit.
template <class Row, class Real>
std::optional<Manifold<Real>> box_manifold(
    const Obb<Real>& a, const Obb<Real>& b, const BoxesInRows<Row>& boxes,
    const Tolerances<Real>& tolerances)
{
  const std::optional<BoxChoice<Real>> choice = box_choice(boxes, tolerances);
  if (!choice)
  {
    return std::nullopt;
  }
  const auto& [face, edge] = *choice;
  return edge.found() ? edge_manifold(a, boxes, edge.index, std::sqrt(edge.squared_depth))
                      : face_manifold(
                            a, b, boxes, face,
                            kept_separation(face.depth, tolerances.margin, tolerances.length),
                            tolerances.length);
}
// [box_manifold]

// [at_unit_size]
/// The manifold of two boxes of any finite size: seen from A, and made of size one by a power of
/// two, which is exact.
template <class Real>
[[gnu::noinline]] std::optional<Manifold<Real>>
box_box_at_unit_size(const Obb<Real>& a, const Obb<Real>& b)
{
  const Real size = a.half_extents.cwiseMax(b.half_extents).maxCoeff();
  const Vector3<Real> quarter = b.center / Real(4) - a.center / Real(4);
  if (!(quarter.cwiseAbs().maxCoeff() <= size))
  {
    return std::nullopt;
  }
  const int exponent = size > 0 ? std::ilogb(size) : 0;
  const Obb<Real> close_by{{0, 0, 0}, a.axes, scaled(a.half_extents, -exponent)};
  const Obb<Real> other{scaled(quarter, 2 - exponent), b.axes, scaled(b.half_extents, -exponent)};
  const auto found = box_manifold(
      close_by, other, boxes_in_rows<RowOf<Real, 3>>(close_by, other),
      tolerances_of(close_by, other));
  return found ? translated(std::optional(scaled(*found, exponent)), a.center) : std::nullopt;
}
// [at_unit_size]

// [box_box_in]
/// box_box() with its numbers in rows of a certain type: see RowOf.
template <class Row, class Real>
[[gnu::flatten]] std::optional<Manifold<Real>> box_box_in(const Obb<Real>& a, const Obb<Real>& b)
{
  const BoxesInRows<Row> boxes = boxes_in_rows<Row>(a, b);
  const Tolerances<Real> tolerances = tolerances_of(a, b);
  if (!has_moderate_size(tolerances.size))
  {
    return box_box_at_unit_size(a, b);
  }
  return box_manifold(a, b, boxes, tolerances);
}
// [box_box_in]

// [box_box]
/// The manifold of two oriented boxes; nothing where they are apart.
///
/// Boxes that only touch have a manifold of depth zero. A face meets a face in all corners of their
/// overlap, each midway between the two surfaces with a depth of its own; corners with a gap are
/// kept while it is less than the depth and than a hundredth of the smaller box. Edges meet in one
/// point. Boxes that touch along an edge have its two ends, at a corner that one. A point's feature
/// tells the axis by 64s, see axis_of_feature(). Half extents are zero or more, axes orthonormal,
/// all numbers finite. O2–O4, O9, O10–O14.
template <class Real>
std::optional<Manifold<Real>> box_box(const Obb<Real>& a, const Obb<Real>& b)
{
  return box_box_in<RowOf<Real, 3>>(a, b);
}
// [box_box]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
