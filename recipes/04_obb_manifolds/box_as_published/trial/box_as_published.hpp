#pragma once

/// \file
/// \brief The manifold of two boxes as the code published beside the seed book computes it.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "04_obb_manifolds/box_as_published/trial/box_as_published_axes.hpp"
#include "04_obb_manifolds/edge_clipping/edge_clipping.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

/// The most points: 24 edges that pass six planes each.
inline constexpr std::size_t most_published_points = 144;

/// Points of a manifold before there is a limit to them; on the heap, as published.
template <class Real>
using PublishedPoints = std::vector<ContactPoint<Real>>;

// [bare_crossings]
/// Edge 0 … 11 of a box, numbered as by each_crossing().
template <class Real>
Segment<Real> box_edge(const Obb<Real>& box, int edge)
{
  const int k = edge / 4, k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  Vector3<Real> start = -box.half_extents;
  start[k1] = edge % 2 == 0 ? start[k1] : -start[k1];
  start[k2] = edge % 4 < 2 ? start[k2] : -start[k2];
  Vector3<Real> end = start;
  end[k] = -start[k];
  return {box.center + box.axes * start, box.center + box.axes * end};
}

/// Adds the points where edges of one box pass planes of the other's faces, if that box holds them
/// to the last digit; X15. Features count from `feature` on.
template <class Real>
void add_bare_crossings(
    const Obb<Real>& edges, const Obb<Real>& faces, std::uint32_t feature,
    PublishedPoints<Real>& points)
{
  for (int pair = 0; pair < int(edge_face_pairs); ++pair)
  {
    const int face = pair % 6;
    const Segment<Real> edge = box_edge(edges, pair / 6);
    const Vector3<Real> normal = (face % 2 == 0 ? Real(1) : Real(-1)) * faces.axes.col(face / 2);
    const Real distance = normal.dot(faces.center) + faces.half_extents[face / 2];
    const Vector3<Real> along = edge.end - edge.start;
    const Real rise = normal.dot(along);
    const Real cut = (distance - normal.dot(edge.start)) / rise;
    const Vector3<Real> point = edge.start + cut * along;
    if (rise != Real(0) && cut >= Real(0) && cut <= Real(1) && contains(faces, point))
    {
      points.push_back({point, Real(0), feature + std::uint32_t(pair)});
    }
  }
}
// [bare_crossings]

// [published_points]
/// All crossings, or, with X15 mended, those of edge_clipping() and its answer for a box inside.
template <class Real>
PublishedPoints<Real> published_crossings(
    const Obb<Real>& a, const Obb<Real>& b, const LeastOverlap<Real>& least, bool bare)
{
  PublishedPoints<Real> points;
  if (bare)
  {
    add_bare_crossings(b, a, 1 + edge_face_pairs, points);
    add_bare_crossings(a, b, 1, points);
    return points;
  }
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Vector3<Real> normal = a.axes.transpose() * least.normal;
  ContactsOnPlane<Real> contacts = contacts_on_middle_plane(boxes, normal, least.depth);
  contacts.same = Real(-1);
  add_crossings(boxes, contacts);
  if (contacts.points.empty())
  {
    contacts.add(contained_point(boxes, normal), 0);
  }
  for (const ContactPoint<Real>& point : contacts.points)
  {
    points.push_back({a.center + a.axes * point.position, Real(0), point.feature});
  }
  return points;
}

/// From the last point to the first, each in place of one after it that is closer than `same`; X16.
template <class Real>
PublishedPoints<Real> merged(const PublishedPoints<Real>& points, Real same)
{
  PublishedPoints<Real> kept;
  for (auto point = points.rbegin(); point != points.rend(); ++point)
  {
    const auto is_same = [&](const ContactPoint<Real>& other)
    { return (other.position - point->position).norm() < same; };
    const auto twin = std::find_if(kept.begin(), kept.end(), is_same);
    if (twin != kept.end())
    {
      kept.erase(twin);
    }
    kept.push_back(*point);
  }
  return {kept.rbegin(), kept.rend()};
}
// [published_points]

// [box_as_published]
/// The published manifold of two boxes, in our own words, with the faults that are in; X08 … X17.
///
/// Boxes can overlap without a point: then `points` is empty. Every point has the whole depth.
template <class Real>
std::optional<Manifold<Real, most_published_points>>
box_as_published(const Obb<Real>& a, const Obb<Real>& b, const PublishedFaults& faults = {})
{
  const std::optional<LeastOverlap<Real>> least = least_as_published(a, b, faults);
  if (!least)
  {
    return std::nullopt;
  }
  const auto& [normal, depth, axis] = *least;
  const Real radius = (a.axes.transpose() * normal).cwiseAbs().dot(a.half_extents);
  const Real middle = normal.dot(a.center) + radius - depth / Real(2);
  PublishedPoints<Real> points = published_crossings(a, b, *least, faults.tests_points_bare);
  for (ContactPoint<Real>& point : points)
  {
    point.position += (middle - normal.dot(point.position)) * normal;
    point.depth = depth;
    point.feature = faults.forgets_features ? 0 : point.feature;
  }
  const Real size = a.half_extents.sum() + b.half_extents.sum();
  Manifold<Real, most_published_points> manifold{normal, depth, {}};
  for (const ContactPoint<Real>& point :
       merged(points, faults.merges_within_1_cm ? Real(0.01) : same_point<Real>() * size))
  {
    manifold.points.push_back(point);
  }
  return manifold;
}
// [box_as_published]

} // namespace cookbook
