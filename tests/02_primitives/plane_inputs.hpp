/// \file
/// Shapes in the plane, drawn on a grid, where the truth is known exactly, and anywhere.
#pragma once

#include "02_primitives/in_the_plane/trial/plane_truth.hpp"
#include "02_primitives/shapes/plane_shapes.hpp"

#include <cmath>
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
  void operator()(OrientedRectangle<Real>& rectangle, GridShape& grid)
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
OrientedRectangle<Real> times_power(const OrientedRectangle<Real>& r, int k)
{
  return {times_power(r.center, k), r.angle, times_power(r.half_extents, k)};
}

} // namespace cookbook
