#pragma once

/// \file
/// \brief Ways to test two boxes that are in use and fail: kept to show where.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

// [six_axes]
/// Tries the faces of both boxes and leaves out the nine pairs of edges.
template <class Real>
std::optional<LeastOverlap<Real>> six_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_overlap(a, b, 6);
}
// [six_axes]

/// The least of fifteen depths; `measure(boxes, axis)` gives a normal in A's frame and a depth, and
/// a negative depth separates.
template <class Real, class Measure>
std::optional<LeastOverlap<Real>>
least_depth(const Obb<Real>& a, const Obb<Real>& b, const Measure& measure)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  LeastOverlap<Real> least{Vector3<Real>::Zero(), std::numeric_limits<Real>::max(), -1};
  for (int axis = 0; axis < box_axes; ++axis)
  {
    if (from_parallel_edges(axis_overlap(boxes, axis)))
    {
      continue;
    }
    const LeastOverlap<Real> candidate = measure(boxes, axis);
    if (candidate.depth < Real(0))
    {
      return std::nullopt;
    }
    least = candidate.depth < least.depth ? candidate : least;
  }
  least.normal = normalize<Real>(a.axes * least.normal).unit;
  return least;
}

/// The axis turned so that it points from A to B.
template <class Real>
Vector3<Real> towards_b(const AxisOverlap<Real>& along)
{
  return along.offset < Real(0) ? Vector3<Real>(-along.axis) : along.axis;
}

// [unnormalized_axes]
/// Compares overlaps along cross products of edges as they come, not divided by their length.
template <class Real>
std::optional<LeastOverlap<Real>> unnormalized_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_depth(
      a, b,
      [](const RelativeBoxes<Real>& boxes, int axis) -> LeastOverlap<Real>
      {
        const AxisOverlap<Real> along = axis_overlap(boxes, axis);
        return {towards_b(along), along.overlap, axis};
      });
}
// [unnormalized_axes]

// [short_radius]
/// B's projected radius along a_i × b_j as two entries of |C|, the short form of O3, right in exact
/// numbers.
template <class Real>
Real short_radius_of_b(const RelativeBoxes<Real>& boxes, int i, int j)
{
  const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  return boxes.half_b[j1] * boxes.absolute(i, j2) + boxes.half_b[j2] * boxes.absolute(i, j1);
}

/// The same fifteen axes with B's projected radius in the short form.
template <class Real>
std::optional<LeastOverlap<Real>> short_radius_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_depth(
      a, b,
      [](const RelativeBoxes<Real>& boxes, int axis) -> LeastOverlap<Real>
      {
        const AxisOverlap<Real> along = axis_overlap(boxes, axis);
        const Real length = std::sqrt(along.squared_length);
        if (axis_kind(axis) != AxisKind::edges)
        {
          return {towards_b(along), along.overlap, axis};
        }
        const int i = (axis - 6) / 3, j = (axis - 6) % 3;
        const Real radius =
            along.axis.cwiseAbs().dot(boxes.half_a) + short_radius_of_b(boxes, i, j);
        return {towards_b(along), (radius - std::abs(along.offset)) / length, axis};
      });
}
// [short_radius]

// [union_depth]
/// Takes for the overlap of two projections the sum of their lengths less that of the whole they
/// cover, turns the normal to where the projection begins later, and does not count touching.
template <class Real>
std::optional<LeastOverlap<Real>> union_depth(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_depth(
      a, b,
      [](const RelativeBoxes<Real>& boxes, int axis) -> LeastOverlap<Real>
      {
        const AxisOverlap<Real> along = axis_overlap(boxes, axis);
        const Vector3<Real> unit = along.axis / std::sqrt(along.squared_length);
        const Real radius_a = unit.cwiseAbs().dot(boxes.half_a);
        const Real radius_b = (boxes.rotation.transpose() * unit).cwiseAbs().dot(boxes.half_b);
        const Real middle_b = boxes.offset.dot(unit);
        const Real begin = std::min(-radius_a, middle_b - radius_b);
        const Real end = std::max(radius_a, middle_b + radius_b);
        const Real depth = Real(2) * radius_a + Real(2) * radius_b - (end - begin);
        const Real sign = middle_b - radius_b < -radius_a ? Real(-1) : Real(1);
        return {sign * unit, depth > Real(0) ? depth : Real(-1), axis};
      });
}
// [union_depth]

// [untolerant_points]
/// The points of edge_clipping() that the other box holds exactly, and no answer for a box inside.
///
/// A point that was computed to lie on a face is outside it as often as inside, by rounding.
template <class Real>
std::vector<Vector3<Real>> untolerant_points(const Obb<Real>& a, const Obb<Real>& b)
{
  const std::optional<LeastOverlap<Real>> least = separating_axes(a, b);
  if (!least)
  {
    return {};
  }
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  ContactsOnPlane<Real> contacts =
      contacts_on_middle_plane<Real>(boxes, a.axes.transpose() * least->normal, least->depth);
  const auto add_edges_of = [&](const Obb<Real>& edges, const Obb<Real>& faces)
  {
    const RelativeBoxes<Real> seen = relative_boxes(faces, edges);
    const auto keep = [&](const Vector3<Real>& point, std::uint32_t)
    {
      const Vector3<Real> world = faces.center + faces.axes * point;
      if (contains(faces, world))
      {
        contacts.add(a.axes.transpose() * (world - a.center), 0);
      }
    };
    each_crossing<Real>({seen.rotation, seen.offset, seen.half_b, seen.half_a}, Real(0), keep);
  };
  add_edges_of(a, b);
  add_edges_of(b, a);
  std::vector<Vector3<Real>> positions;
  for (const ContactPoint<Real>& point : contacts.points)
  {
    positions.push_back(a.center + a.axes * point.position);
  }
  return positions;
}
// [untolerant_points]

} // namespace cookbook
