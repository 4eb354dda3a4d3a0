/// \file
/// An oracle of closest points that shares no code with the book's: it knows what lies in a shape
/// and how far the shape reaches.
#pragma once

#include "02_primitives/shapes/answers.hpp"

#include "tests/02_primitives/oracle_shapes.hpp"
#include "tests/02_primitives/shape_draws.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook
{

/// The way [m] to a point from the closest point of a segment.
inline Long3 vector_from_segment(const Long3& p, const Long3& a, const Long3& b)
{
  const Long3 ab = b - a;
  const Long t = ab.isZero(0) ? Long(0) : std::clamp<Long>((p - a).dot(ab) / ab.dot(ab), 0, 1);
  return p - a - t * ab;
}

/// The distance [m] of a point from a triangle: from its nearest edge or, if it is above, from its
/// plane, measured from that edge, for the normal of a thin triangle is uncertain.
inline Long from_triangle(const Long3& p, const Long3& a, const Long3& b, const Long3& c)
{
  Long3 difference = vector_from_segment(p, a, b);
  for (const Long3& other : {vector_from_segment(p, b, c), vector_from_segment(p, c, a)})
  {
    difference = other.norm() < difference.norm() ? other : difference;
  }
  const Long3 n = (b - a).cross(c - a);
  const Long length = n.norm();
  const bool above = length > 0 && n.dot((b - a).cross(p - a)) >= 0 &&
                     n.dot((c - b).cross(p - b)) >= 0 && n.dot((a - c).cross(p - c)) >= 0;
  return above ? std::abs(n.dot(difference)) / length : difference.norm();
}

/// How far [m] a point lies outside of a shape; 0 inside.
inline Long outside(const OracleShape& shape, const Long3& p)
{
  const std::vector<Long3>& c = shape.corners;
  Long distance = 0;
  if (!shape.sides.empty())
  {
    for (const auto& [x, y, z, offset] : shape.sides)
    {
      distance = std::max(distance, p.dot(Long3(x, y, z)) - offset);
    }
    return distance;
  }
  switch (c.size())
  {
  case 1:
    distance = (p - c[0]).norm();
    break;
  case 2:
    distance = vector_from_segment(p, c[0], c[1]).norm();
    break;
  case 3:
    distance = from_triangle(p, c[0], c[1], c[2]);
    break;
  default:
    bool inside = true;
    distance = from_triangle(p, c[1], c[2], c[3]);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Long3 &q = c[(i + 1) % 4], &r = c[(i + 2) % 4], &s = c[(i + 3) % 4];
      distance = std::min(distance, from_triangle(p, q, r, s));
      const Long3 n = (r - q).cross(s - q);
      inside = inside && n.dot(p - q) * n.dot(c[i] - q) > 0;
    }
    distance = inside ? Long(0) : distance;
  }
  return std::max(Long(0), distance - shape.radius);
}

/// The least of n·x over a shape, for a unit vector n.
inline Long extent_against(const OracleShape& shape, const Long3& n)
{
  if (shape.is_plane)
  {
    const auto& [x, y, z, offset] = shape.sides[0];
    const bool against = (n + Long3(x, y, z)).norm() < Long(1e-6);
    return against ? -offset : -std::numeric_limits<Long>::infinity();
  }
  Long least = shape.corners[0].dot(n);
  for (const Long3& corner : shape.corners)
  {
    least = std::min(least, corner.dot(n));
  }
  return least - shape.radius;
}

/// The size [m] of the numbers that a pair is made of, for what rounding may do.
inline Long size_of_numbers(const OracleShape& a, const OracleShape& b)
{
  Long size = std::max(a.radius, b.radius);
  for (const OracleShape* shape : {&a, &b})
  {
    for (const Long3& corner : shape->corners)
    {
      size = std::max(size, corner.cwiseAbs().maxCoeff());
    }
    size = shape->is_plane ? std::max(size, std::abs(shape->sides[0][3])) : size;
  }
  return size > 0 ? size : Long(1);
}

/// What is wrong with closest points, as a fraction of the size of the numbers: no answer is closer
/// if both points are in their shapes and the shapes lie on either side of the gap between two
/// planes through the points; an overlap is one if a point is in both.
inline Long fault(const OracleShape& a, const OracleShape& b, const ClosestPoints<Long, 3>& points)
{
  if (!points.a.allFinite() || !points.b.allFinite() || !std::isfinite(points.distance))
  {
    return std::numeric_limits<Long>::infinity();
  }
  // Planes that are nearly parallel meet far away.
  const Long from_origin = a.is_plane && b.is_plane ? points.a.norm() : Long(0);
  const Long size = std::max(size_of_numbers(a, b), from_origin);
  Long wrong = std::max(outside(a, points.a), outside(b, points.b));
  wrong = std::max(wrong, std::abs((points.a - points.b).norm() - points.distance));
  if (points.distance == Long(0))
  {
    return (points.a != points.b ? size : wrong) / size;
  }
  const Long3 difference = points.a - points.b;
  const Long distance = difference.norm();
  Long3 n = difference / distance;
  // A plane's own normal is more certain than a way between points that are rounded.
  if (a.is_plane || b.is_plane)
  {
    const std::array<Long, 4>& side = a.is_plane ? a.sides[0] : b.sides[0];
    n = (a.is_plane ? Long(-1) : Long(1)) * Long3(side[0], side[1], side[2]);
  }
  // Points that are rounded tilt a short way: the shorter it is, the less it can tell.
  const Long tilt = std::max(Long(1), size / distance * Long(0.1));
  const Long cut =
      std::max(n.dot(points.a) - extent_against(a, n), -n.dot(points.b) - extent_against(b, -n));
  return std::max(wrong, cut / tilt) / size;
}

/// An answer in long double.
template <class Real>
ClosestPoints<Long, 3> exactly(const ClosestPoints<Real, 3>& points)
{
  return {exactly(points.a), exactly(points.b), Long(points.distance)};
}

} // namespace cookbook
