#pragma once

/// \file
/// \brief Which contact points on one surface a body needs: the corners of their convex hull.

#include "06_world/seams/seams.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

namespace cookbook
{

// [surface_hull]
/// Of points at one place keeps one: which was known before, or that of the body first in x, y, z.
inline void keep_one_a_place(std::vector<SurfacePoint>& points, double tolerance)
{
  const auto before = [](const SurfacePoint& one, const SurfacePoint& other)
  {
    const Vector3<double>&p = one.fixed_center, &q = other.fixed_center;
    return std::tuple(!one.known, p.x(), p.y(), p.z()) <
           std::tuple(!other.known, q.x(), q.y(), q.z());
  };
  for (SurfacePoint& one : points)
  {
    for (SurfacePoint& other : points)
    {
      if (&one != &other && one.kept && other.kept &&
          (one.on_body - other.on_body).squaredNorm() <= tolerance * tolerance)
      {
        (before(other, one) ? one : other).kept = false;
      }
    }
  }
}

/// How far [m] a point is to the left of the line from one to another; zero where these are
/// at one place.
inline double
left_of(const Vector2<double>& from, const Vector2<double>& to, const Vector2<double>& point)
{
  const Vector2<double> along = to - from, between = point - from;
  const double length = along.norm();
  return length > 0 ? (along.x() * between.y() - along.y() * between.x()) / length : 0;
}

/// Writes the convex hull of the points that are kept, counter-clockwise (monotone chain); a point
/// within a tolerance [m] of the line between its neighbours is no corner.
inline void find_hull(
    const std::vector<SurfacePoint>& points, std::vector<std::size_t>& order,
    std::vector<std::size_t>& hull, double tolerance)
{
  order.clear();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points[i].kept)
    {
      order.push_back(i);
    }
  }
  const auto place = [&](std::size_t i) -> const Vector2<double>& { return points[i].place; };
  std::sort(
      order.begin(), order.end(),
      [&](std::size_t i, std::size_t j)
      { return std::pair(place(i).x(), place(i).y()) < std::pair(place(j).x(), place(j).y()); });
  hull.clear();
  const auto add = [&](std::size_t i, std::size_t first)
  {
    while (hull.size() >= first + 2 &&
           left_of(place(hull[hull.size() - 2]), place(i), place(hull.back())) >= -tolerance)
    {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  for (const std::size_t i : order)
  {
    add(i, 0);
  }
  const std::size_t lower = hull.size() - 1;
  for (std::size_t k = order.size() - 1; k-- > 0;)
  {
    add(order[k], lower);
  }
  if (hull.size() > 1)
  {
    hull.pop_back(); // the first once more
  }
}

/// Whether all points are in one plane, to a tolerance [m]: that of the three corners of their hull
/// that span most.
inline bool are_flat(
    const std::vector<SurfacePoint>& points, const std::vector<std::size_t>& hull, double tolerance)
{
  if (hull.size() < 3)
  {
    return true; // along a line, and a body is convex
  }
  const Vector3<double>& origin = points[hull[0]].on_body;
  Vector3<double> most = Vector3<double>::Zero();
  for (std::size_t i = 2; i < hull.size(); ++i)
  {
    const Vector3<double> normal =
        (points[hull[i - 1]].on_body - origin).cross(points[hull[i]].on_body - origin);
    most = normal.squaredNorm() > most.squaredNorm() ? normal : most;
  }
  const double reach = tolerance * most.norm();
  return std::all_of(
      points.begin(), points.end(),
      [&](const SurfacePoint& point)
      { return std::abs(most.dot(point.on_body - origin)) <= reach; });
}

/// Keeps of the points of a body on one surface those which bear as much as all: the corners of
/// their hull. Where the body does not lie flat to a tolerance [m], all are kept, but for those at
/// one place.
inline void keep_hull(
    std::vector<SurfacePoint>& points, std::vector<std::size_t>& order,
    std::vector<std::size_t>& hull, double tolerance)
{
  double farthest = 0;
  for (const SurfacePoint& point : points)
  {
    farthest = std::max(farthest, point.on_body.norm());
  }
  const double rounding = stays_in_place * farthest; // seams cross a body's edges to rounding
  keep_one_a_place(points, rounding);
  const auto kept = [](const SurfacePoint& point) { return point.kept; };
  if (std::count_if(points.begin(), points.end(), kept) < 3)
  {
    return;
  }
  find_hull(points, order, hull, rounding);
  if (!are_flat(points, hull, tolerance))
  {
    return;
  }
  for (SurfacePoint& point : points)
  {
    point.kept = false;
  }
  for (const std::size_t i : hull)
  {
    points[i].kept = true;
  }
}
// [surface_hull]

} // namespace cookbook
