#pragma once

/// \file
/// \brief The edge functions of a convex polygon in a picture, and the pixels of a row inside of
/// them.

#include "common/math/vector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cookbook
{

/// A few corners, in an array of their own: at most 48; more are left out.
template <class Point>
struct CornerList
{
  std::array<Point, 48> points; ///< the first `size` of them count
  std::size_t size = 0;         ///< how many there are

  /// Adds a corner.
  void add(const Point& point)
  {
    if (size < points.size())
    {
      points[size++] = point;
    }
  }
};

/// Corners in the picture: x, y [pixels] from the upper left corner, y down, and depth.
using ScreenPolygon = CornerList<Vector3<double>>;

// [edge]
/// A pixel has 256 × 256 places for a corner.
constexpr std::int64_t subpixels = 256;

/// An edge of a polygon: its edge function, at pixels' centres, in whole numbers.
struct Edge
{
  std::int64_t value;  ///< at the centre of the picture's upper left pixel; inside it is ≥ 0
  std::int64_t per_x;  ///< how much it grows from a pixel to the next
  std::int64_t per_y;  ///< how much it grows from a row to the next
  std::int64_t length; ///< of the edge [1/256 pixel]
};
// [edge]

/// The place of a coordinate [pixels] in whole 256ths.
inline std::int64_t snapped(double x)
{
  return static_cast<std::int64_t>(std::floor(x * static_cast<double>(subpixels) + 0.5));
}

// [edge_between]
/// The edge from a to b of a polygon that turns clockwise as seen, P24.
///
/// A centre on an edge belongs to the polygon whose left or upper edge it is, and to no other.
inline Edge edge_between(const Vector3<double>& a, const Vector3<double>& b)
{
  const std::int64_t ax = snapped(a.x()), ay = snapped(a.y());
  const std::int64_t dx = snapped(b.x()) - ax, dy = snapped(b.y()) - ay;
  const std::int64_t half = subpixels / 2;
  const bool keeps_its_own = dy < 0 || (dy == 0 && dx > 0);
  const double x = static_cast<double>(dx), y = static_cast<double>(dy);
  return {
      dx * (half - ay) - dy * (half - ax) - (keeps_its_own ? 0 : 1), -dy * subpixels,
      dx * subpixels, static_cast<std::int64_t>(std::sqrt(x * x + y * y))};
}
// [edge_between]

/// The pixels of a row from `first` to before `last`.
struct RowSpan
{
  std::int64_t first; ///< its first pixel
  std::int64_t last;  ///< the pixel after its last one
};

/// The quotient rounded up, for a divisor above zero.
constexpr std::int64_t divided_up(std::int64_t a, std::int64_t b)
{
  return a / b + (a % b > 0 ? 1 : 0);
}

// [inside]
/// The part of a row's span that is inside of an edge by `margin` [1/256 pixel] or more.
///
/// Along a row the edge function grows evenly: one division finds where it changes its sign.
inline RowSpan inside(const RowSpan& span, const Edge& edge, std::int64_t y, std::int64_t margin)
{
  const std::int64_t at_zero = edge.value + y * edge.per_y - margin * edge.length;
  if (edge.per_x > 0)
  {
    return {std::max(span.first, divided_up(-at_zero, edge.per_x)), span.last};
  }
  if (edge.per_x < 0)
  {
    return {span.first, std::min(span.last, divided_up(at_zero + 1, -edge.per_x))};
  }
  return {span.first, at_zero < 0 ? span.first : span.last};
}
// [inside]

/// The edges of a polygon that turns clockwise as seen; those without a length are left out.
inline CornerList<Edge> edges_of(const ScreenPolygon& polygon)
{
  CornerList<Edge> edges;
  for (std::size_t i = 0; i < polygon.size; ++i)
  {
    const std::size_t next = i + 1 == polygon.size ? 0 : i + 1;
    const Edge edge = edge_between(polygon.points[i], polygon.points[next]);
    if (edge.per_x != 0 || edge.per_y != 0)
    {
      edges.add(edge);
    }
  }
  return edges;
}

} // namespace cookbook
