/// \file
/// Shapes in the plane, drawn on a grid, where the truth is known exactly, and anywhere.
#pragma once

#include "02_primitives/in_the_plane/trial/plane_truth.hpp"
#include "02_primitives/shapes/plane_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace cookbook
{

/// A point of the grid that is five times as fine, for turned corners have fifths.
inline GridPoint fifths(std::int64_t x, std::int64_t y)
{
  return {5 * x, 5 * y};
}

/// Draws shapes with whole numbers, many of which touch, and the same on the grid of fifths.
class GridDraw
{
public:
  explicit GridDraw(unsigned seed) : engine_(seed) {}

  int whole(int least, int most) ///< each as often
  {
    return least + int(engine_() % unsigned(most - least + 1));
  }

  template <class Real>
  void operator()(Vector<Real, 2>& point, GridShape& grid)
  {
    const int x = whole(-6, 6), y = whole(-6, 6);
    point = {Real(x), Real(y)};
    grid = {{fifths(x, y)}};
  }

  template <class Real>
  void operator()(Segment2<Real>& segment, GridShape& grid)
  {
    GridShape end;
    (*this)(segment.start, grid);
    (*this)(segment.end, end);
    grid.corners.push_back(end.corners[0]);
  }

  template <class Real>
  void operator()(Circle<Real>& circle, GridShape& grid)
  {
    (*this)(circle.center, grid);
    const int radius = whole(0, 5);
    circle.radius = Real(radius);
    grid.radius = 5 * radius;
  }

  template <class Real>
  void operator()(Rectangle<Real>& rectangle, GridShape& grid)
  {
    (*this)(rectangle.center, grid);
    const int x = whole(0, 3), y = whole(0, 3);
    rectangle.half_extents = {Real(x), Real(y)};
    add_corners(grid, fifths(x, 0), fifths(0, y));
  }

  /// Turned so that its axes are (4, 3) / 5 and (-3, 4) / 5, or by these and a half turn.
  template <class Real>
  void operator()(TurnedRectangle<Real>& rectangle, GridShape& grid)
  {
    (*this)(rectangle.center, grid);
    const int x = whole(0, 3), y = whole(0, 3), half_turns = whole(-2, 2);
    rectangle.half_extents = {Real(x), Real(y)};
    rectangle.angle = Real(std::atan2(3.0, 4.0) + half_turns * std::acos(-1.0));
    add_corners(grid, {4 * x, 3 * x}, {-3 * y, 4 * y});
  }

private:
  static void add_corners(GridShape& grid, const GridPoint& x, const GridPoint& y)
  {
    const GridPoint c = grid.corners[0];
    grid.corners = {
        {c.x - x.x - y.x, c.y - x.y - y.y},
        {c.x + x.x - y.x, c.y + x.y - y.y},
        {c.x + x.x + y.x, c.y + x.y + y.y},
        {c.x - x.x + y.x, c.y - x.y + y.y}};
  }

  std::mt19937 engine_;
};

/// A shape times a power of two.
template <class Real>
Vector<Real, 2> times_power(const Vector<Real, 2>& p, int k)
{
  return {std::ldexp(p.x(), k), std::ldexp(p.y(), k)};
}

template <class Real>
Segment2<Real> times_power(const Segment2<Real>& s, int k)
{
  return {times_power(s.start, k), times_power(s.end, k)};
}

template <class Real>
Circle<Real> times_power(const Circle<Real>& c, int k)
{
  return {times_power(c.center, k), std::ldexp(c.radius, k)};
}

template <class Real>
Rectangle<Real> times_power(const Rectangle<Real>& r, int k)
{
  return {times_power(r.center, k), times_power(r.half_extents, k)};
}

template <class Real>
TurnedRectangle<Real> times_power(const TurnedRectangle<Real>& r, int k)
{
  return {times_power(r.center, k), r.angle, times_power(r.half_extents, k)};
}

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
Around around(const TurnedRectangle<Real>& r)
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
  return around(TurnedRectangle<Real>{r.center, Real(0), r.half_extents});
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
    const Long share = length > 0 ? std::clamp(from.dot(edge) / length, Long(0), Long(1)) : 0;
    nearest = std::min(nearest, (from - share * edge).norm());
  }
  return within ? 0 : double(std::max(Long(0), nearest - shape.radius));
}

/// How far the shape reaches beyond the line through p square to the unit vector n.
inline double reach_beyond(const Around& shape, const Vector<Long, 2>& p, const Vector<Long, 2>& n)
{
  Long most = -std::numeric_limits<Long>::infinity();
  for (std::size_t i = 0; i < shape.count; ++i)
  {
    most = std::max(most, (shape.corners[i] - p).dot(n) + shape.radius);
  }
  return double(most);
}

} // namespace cookbook
