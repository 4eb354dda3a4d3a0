/// \file
/// Shapes in the plane with more digits, by which closest points and hits are checked.
#pragma once

#include "02_primitives/shapes/plane_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cookbook
{

/// A number with more digits than those that are checked.
using Long = long double;

/// Corners and radius with more digits: what answers are checked with.
struct Around
{
  std::array<Vector<Long, 2>, 4> corners;
  std::size_t count;
  Long radius;
  double size; ///< the largest number
};

template <class Real>
Around around(const Vector<Real, 2>& p)
{
  const Vector<Long, 2> at = p.template cast<Long>();
  return {{at, at, at, at}, 1, 0, double(p.cwiseAbs().maxCoeff())};
}

template <class Real>
Around around(const Segment2<Real>& s)
{
  const Around start = around(s.start), end = around(s.end);
  return {
      {start.corners[0], end.corners[0], end.corners[0], end.corners[0]},
      2,
      0,
      std::max(start.size, end.size)};
}

template <class Real>
Around around(const Circle<Real>& c)
{
  Around center = around(c.center);
  center.radius = c.radius;
  center.size = std::max(center.size, double(c.radius));
  return center;
}

template <class Real>
Around around(const OrientedRectangle<Real>& r)
{
  const Long angle = r.angle, hx = r.half_extents.x(), hy = r.half_extents.y();
  const Vector<Long, 2> x(std::cos(angle), std::sin(angle)), y(-x.y(), x.x());
  const Vector<Long, 2> c = r.center.template cast<Long>(), to_x = hx * x, to_y = hy * y;
  const double half = double(r.half_extents.maxCoeff());
  return {
      {c - to_x - to_y, c + to_x - to_y, c + to_x + to_y, c - to_x + to_y},
      4,
      0,
      std::max(around(r.center).size, half)};
}

template <class Real>
Around around(const Rectangle<Real>& r)
{
  return around(OrientedRectangle<Real>{r.center, Real(0), r.half_extents});
}

/// How far [m] a point is from a shape, 0 within, by all edges.
inline double out_of(const Around& shape, const Vector<Long, 2>& p)
{
  bool within = shape.count > 2;
  Long nearest = std::numeric_limits<Long>::infinity();
  for (std::size_t i = 0; i < shape.count; ++i)
  {
    const Vector<Long, 2>&a = shape.corners[i], &b = shape.corners[(i + 1) % shape.count];
    const Vector<Long, 2> edge = b - a, from = p - a;
    within = within && edge.x() * from.y() - edge.y() * from.x() >= 0;
    const Long length = edge.squaredNorm();
    const Long fraction = length > 0 ? std::clamp(from.dot(edge) / length, Long(0), Long(1)) : 0;
    nearest = std::min(nearest, (from - fraction * edge).norm());
  }
  return within ? 0 : double(std::max(Long(0), nearest - shape.radius));
}

/// How far the shape reaches beyond the line through p perpendicular to the unit vector n.
inline double extent_beyond(const Around& shape, const Vector<Long, 2>& p, const Vector<Long, 2>& n)
{
  Long most = -std::numeric_limits<Long>::infinity();
  for (std::size_t i = 0; i < shape.count; ++i)
  {
    most = std::max(most, (shape.corners[i] - p).dot(n) + shape.radius);
  }
  return double(most);
}

} // namespace cookbook
