#pragma once

/// \file
/// \brief Whether two convex polygons overlap: the separating axis test as it stands.

#include "02_primitives/shapes/plane_shapes.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

/// The corners of a convex polygon [m], in order, either way round.
template <class Real>
using Polygon = std::vector<Vector2<Real>>;

// [polygons_overlap]
/// Whether the projections of two polygons on an axis leave a gap between them.
template <class Real>
bool is_separating(const Vector2<Real>& axis, const Polygon<Real>& a, const Polygon<Real>& b)
{
  const auto before = [&](const Vector2<Real>& p, const Vector2<Real>& q)
  { return axis.dot(p) < axis.dot(q); };
  const auto [a_least, a_most] = std::minmax_element(a.begin(), a.end(), before);
  const auto [b_least, b_most] = std::minmax_element(b.begin(), b.end(), before);
  return before(*a_most, *b_least) || before(*b_most, *a_least);
}

/// Whether an axis perpendicular to an edge of `edges` separates two polygons.
template <class Real>
bool an_edge_separates(const Polygon<Real>& edges, const Polygon<Real>& a, const Polygon<Real>& b)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const Vector2<Real> along = edges[(i + 1) % edges.size()] - edges[i];
    if (is_separating<Real>({-along.y(), along.x()}, a, b))
    {
      return true;
    }
  }
  return false;
}

/// Whether two convex polygons with an area have a point in common; touching counts.
template <class Real>
bool polygons_overlap(const Polygon<Real>& a, const Polygon<Real>& b)
{
  return !an_edge_separates(a, a, b) && !an_edge_separates(b, a, b);
}
// [polygons_overlap]

// [mean_circle]
/// The circle about the mean of points, of which there is at least one, to the farthest of them;
/// P22.
template <class Real>
Circle<Real> mean_circle(const std::vector<Vector2<Real>>& points)
{
  Circle<Real> circle{Vector2<Real>::Zero(), Real(0)};
  for (const Vector2<Real>& p : points)
  {
    circle.center += p / Real(points.size());
  }
  for (const Vector2<Real>& p : points)
  {
    circle.radius = std::max(circle.radius, Real((p - circle.center).norm()));
  }
  return circle;
}
// [mean_circle]

} // namespace cookbook
