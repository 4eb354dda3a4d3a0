#pragma once

/// \file
/// \brief Contact points of two boxes as the published code finds and merges them.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

/// Points of a manifold without a limit to their number; on the heap, as published.
template <class Real>
using PublishedPoints = std::vector<ContactPoint<Real>>;

// [published_points]
/// Edge 0 … 11 of a box.
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

/// Adds the points where edges of one box pass planes of the other's faces. X15: only those that
/// this box holds to the last digit. X17: what meets there is forgotten.
template <class Real>
void add_bare_crossings(
    const Obb<Real>& edges, const Obb<Real>& faces, PublishedPoints<Real>& points)
{
  for (int pair = 0; pair < 72; ++pair)
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
      points.push_back({point, Real(0), 0});
    }
  }
}

/// From the last point to the first, each in place of one after it that is closer than `same` [m].
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

} // namespace cookbook
