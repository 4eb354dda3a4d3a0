#pragma once

/// \file
/// \brief The manifold of two boxes that remembers the frame before: its axis, its points, and what
/// was known of each.

#include "02_primitives/boxes_overlap/box_axes.hpp"
#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/feature_memory/contact_memory.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <cmath>
#include <utility>

namespace cookbook
{

/// The axis, 0 … 14, on which box_box() builds its manifold, and the overlap [m] along it; nothing
/// where the boxes are apart.
template <class Row, class Real>
[[gnu::flatten]] std::optional<std::pair<int, Real>>
box_axis_in(const Obb<Real>& a, const Obb<Real>& b)
{
  const BoxesInRows<Row> boxes = boxes_in_rows<Row>(a, b);
  const Tolerances<Real> tolerances = tolerances_of(a, b);
  if (!has_moderate_size(tolerances.size))
  {
    const std::optional<Manifold<Real>> found = box_box_at_unit_size(a, b);
    return found ? std::optional(
                       std::pair(static_cast<int>(found->points[0].feature / 64), found->depth))
                 : std::nullopt;
  }
  const std::optional<BoxChoice<Real>> choice = box_choice(boxes, tolerances);
  if (!choice)
  {
    return std::nullopt;
  }
  const auto& [face, edge] = *choice;
  return edge.found() ? std::pair(6 + edge.index, Real(std::sqrt(edge.squared_depth)))
                      : std::pair(face.index, face.depth);
}

// [on_axis]
/// The direction of an axis, 0 … 14, of two boxes, of length one; it may point from B to A.
template <class Real>
Vector3<Real> axis_direction(const Obb<Real>& a, const Obb<Real>& b, int axis)
{
  switch (axis_kind(axis))
  {
  case AxisKind::face_of_a:
    return a.axes.col(axis);
  case AxisKind::face_of_b:
    return b.axes.col(axis - 3);
  default:
    return a.axes.col((axis - 6) / 3).cross(b.axes.col((axis - 6) % 3)).normalized();
  }
}

/// The overlap of two boxes along an axis, 0 … 14 [m]; negative if they are apart along it, and
/// nothing if it comes from parallel edges.
template <class Real>
std::optional<Real> overlap_on(const Obb<Real>& a, const Obb<Real>& b, int axis)
{
  using std::sqrt;
  const AxisOverlap<Real> along = axis_overlap(relative_boxes(a, b), axis);
  return from_parallel_edges(along) ? std::nullopt
                                    : std::optional(along.overlap / sqrt(along.squared_length));
}

/// The manifold of two boxes on an axis, 0 … 14, that the caller chose, along which they overlap by
/// `depth` [m]; below zero they are apart. Corners with a gap are kept up to `widest_separation`
/// [m]; a length within the tolerance [m] decides no corner.
template <class Row, class Real>
std::optional<Manifold<Real>> box_box_on(
    const Obb<Real>& a, const Obb<Real>& b, int axis, const Real& depth,
    const Real& widest_separation, const Real& tolerance)
{
  const BoxesInRows<Row> boxes = boxes_in_rows<Row>(a, b);
  return axis_kind(axis) == AxisKind::edges
             ? edge_manifold(a, boxes, axis - 6, depth)
             : face_manifold(
                   a, b, boxes, LeastFace<Real>{depth, axis}, widest_separation, tolerance);
}

/// The same with the separation and the tolerance of box_box().
template <class Row, class Real>
std::optional<Manifold<Real>>
box_box_on(const Obb<Real>& a, const Obb<Real>& b, int axis, const Real& depth)
{
  const Tolerances<Real> tolerances = tolerances_of(a, b);
  const Real separation = kept_separation(depth, tolerances.margin, tolerances.length);
  return box_box_on<Row>(a, b, axis, depth, separation, tolerances.length);
}
// [on_axis]

// [keeps_axis]
/// How much less [m] a new axis must overlap before the old one is given up for it: a hundredth of
/// the smaller box's mean half extent and a tenth of the depth.
///
/// The length is for boxes that barely touch, the part of the depth for those sunk deep.
template <class Real>
Real axis_margin(const Obb<Real>& a, const Obb<Real>& b, Real depth)
{
  using std::min;
  const Real smaller = min(a.half_extents.sum(), b.half_extents.sum()) / Real(3);
  return Real(0.01) * smaller + Real(0.1) * depth;
}

/// The axis, 0 … 14, on which the manifold of this frame is built, and the overlap [m] along it:
/// those of the frame before, −1 if there was none, or those that were found now; O17.
///
/// A pair of edges gives way to a face that overlaps by no more than half the margin more: where an
/// edge lies along a face, its one point would be now at this end of it, now at that.
template <class Real>
std::pair<int, Real>
steady_axis(int before, const Obb<Real>& a, const Obb<Real>& b, const std::pair<int, Real>& found)
{
  const auto [now, depth] = found;
  const Real margin = axis_margin(a, b, depth);
  std::pair<int, Real> steady = found;
  if (before >= 0 && before != now)
  {
    const std::optional<Real> overlap = overlap_on(a, b, before);
    if (overlap && *overlap >= Real(0) && *overlap <= depth + margin)
    {
      steady = {before, *overlap};
    }
  }
  if (axis_kind(steady.first) == AxisKind::edges)
  {
    const std::optional<LeastOverlap<Real>> face = least_overlap(a, b, 6);
    if (face && face->depth <= depth + margin / Real(2))
    {
      steady = {face->axis, face->depth};
    }
  }
  return steady;
}
// [keeps_axis]

// [feature_memory]
/// next_frame() with its numbers in rows of a certain type: see RowOf.
template <class Row, class Real, class Warm>
ContactMemory<Real, Warm>
next_frame_in(const ContactMemory<Real, Warm>& before, const Obb<Real>& a, const Obb<Real>& b)
{
  ContactMemory<Real, Warm> now{box_box_in<Row>(a, b), {}};
  if (!now.manifold || !before.manifold)
  {
    return now;
  }
  const int found = axis_of(now.manifold);
  const auto [axis, overlap] =
      steady_axis(axis_of(before.manifold), a, b, std::pair(found, now.manifold->depth));
  if (axis != found)
  {
    now.manifold = box_box_on<Row>(a, b, axis, overlap);
  }
  now.warm = carried_by_id(*before.manifold, before.warm, *now.manifold);
  return now;
}

/// The contact of two boxes in this frame, from that in the frame before; O17.
///
/// As box_box(), but on the axis that steady_axis() says. Points whose features were there before
/// keep what was known of them. A memory without a manifold is how to begin, with what box_box()
/// answers; boxes that separate forget everything.
template <class Real, class Warm>
ContactMemory<Real, Warm>
next_frame(const ContactMemory<Real, Warm>& before, const Obb<Real>& a, const Obb<Real>& b)
{
  return next_frame_in<RowOf<Real, 3>>(before, a, b);
}
// [feature_memory]

} // namespace cookbook
