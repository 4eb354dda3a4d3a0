#pragma once

/// \file
/// \brief Which pixels a convex polygon covers, and how deep it is at each.

#include "02_primitives/picture/canvas.hpp"
#include "02_primitives/picture/edges.hpp"
#include "common/math/vector.hpp"

#include <algorithm>

namespace cookbook
{

// [depth_plane]
/// Depth over the picture: a plane, for the projection keeps planes plane.
struct DepthPlane
{
  double at_zero = 0; ///< where x and y are 0
  double per_x = 0;   ///< [1/pixel]
  double per_y = 0;   ///< [1/pixel]
  double least = -1;  ///< what it is clamped to: the least and …
  double most = 1;    ///< … the greatest depth of a corner
};

/// The plane through a polygon's corners; a polygon without an area has depth 1, which is never
/// drawn.
inline DepthPlane depth_plane(const ScreenPolygon& polygon)
{
  const Vector3<double> first = polygon.points[0];
  Vector3<double> normal(0, 0, 0); // twice the polygon's area, whichever triangle is thin
  DepthPlane plane{1, 0, 0, first.z(), first.z()};
  for (std::size_t i = 1; i < polygon.size; ++i)
  {
    const Vector3<double> p = polygon.points[i];
    normal += (polygon.points[i - 1] - first).cross(p - first);
    plane.least = std::min(plane.least, p.z());
    plane.most = std::max(plane.most, p.z());
  }
  if (normal.z() != 0)
  {
    plane.per_x = -normal.x() / normal.z();
    plane.per_y = -normal.y() / normal.z();
    plane.at_zero = first.z() - plane.per_x * first.x() - plane.per_y * first.y();
  }
  return plane;
}
// [depth_plane]

/// How pixels are painted.
struct Paint
{
  Colour fill;            ///< inside; mixed with what is there if it is not opaque
  Colour edge = {};       ///< along the edges
  double edge_pixels = 0; ///< how wide the edges are drawn, [drawn pixels]
  bool tested = true;     ///< hidden by what is nearer; else drawn over everything
};

// [paint_span]
/// Calls `paint` with the place and the depth of each pixel of a row's span.
template <class Paint>
void each_depth(
    const Picture& picture, int y, const RowSpan& span, const DepthPlane& plane, const Paint& paint)
{
  const double row = plane.at_zero + plane.per_y * (y + 0.5) + plane.per_x * 0.5;
  const std::size_t start = row_start(picture, y);
  for (std::int64_t x = span.first; x < span.last; ++x)
  {
    const double depth = row + plane.per_x * static_cast<double>(x);
    const double kept = std::min(std::max(depth, plane.least), plane.most);
    paint(start + static_cast<std::size_t>(x), static_cast<float>(kept));
  }
}

/// Paints the pixels of a row's span that are nearer than what is there.
inline void paint_span(
    Picture& picture, int y, const RowSpan& span, const DepthPlane& plane, const Colour& colour)
{
  const std::uint32_t pixel = to_pixel(colour);
  each_depth(
      picture, y, span, plane,
      [&](std::size_t at, float depth)
      {
        if (depth < picture.depth[at])
        {
          picture.depth[at] = depth;
          picture.pixels[at] = pixel;
        }
      });
}
// [paint_span]

/// The same for what is not opaque, or is drawn over everything and then leaves the depths alone.
inline void mix_span(
    Picture& picture, int y, const RowSpan& span, const DepthPlane& plane, const Colour& colour,
    bool tested)
{
  each_depth(
      picture, y, span, plane,
      [&](std::size_t at, float depth)
      {
        if (!tested || depth < picture.depth[at])
        {
          picture.depth[at] = tested ? depth : picture.depth[at];
          picture.pixels[at] = to_pixel(mixed(to_colour(picture.pixels[at]), colour, colour.a));
        }
      });
}

/// Paints a span in the way that the paint asks for.
inline void paint_row(
    Picture& picture, int y, const RowSpan& span, const DepthPlane& plane, const Colour& colour,
    bool tested)
{
  if (tested && colour.a == 255)
  {
    paint_span(picture, y, span, plane, colour);
  }
  else
  {
    mix_span(picture, y, span, plane, colour, tested);
  }
}

// [fill_polygon]
/// Paints a convex polygon that turns clockwise as seen; of one that turns the other way, nothing.
///
/// Its coordinates must be finite, and at most a million.
inline void fill_polygon(
    Picture& picture, const ScreenPolygon& polygon, const DepthPlane& plane, const Paint& paint)
{
  const CornerList<Edge> edges = edges_of(polygon);
  double top = picture.height, bottom = 0;
  for (std::size_t i = 0; i < polygon.size; ++i)
  {
    top = std::min(top, polygon.points[i].y() - 1);
    bottom = std::max(bottom, polygon.points[i].y() + 1);
  }
  const int first = static_cast<int>(std::max(top, 0.0));
  const int last = static_cast<int>(std::min(bottom, static_cast<double>(picture.height)));
  const std::int64_t margin = snapped(paint.edge_pixels);
  for (int y = first; y < last && edges.size >= 3; ++y)
  {
    RowSpan whole{0, picture.width}, inner = whole;
    for (std::size_t i = 0; i < edges.size; ++i)
    {
      whole = inside(whole, edges.points[i], y, 0);
      inner = inside(inner, edges.points[i], y, margin);
    }
    if (whole.first >= whole.last)
    {
      continue;
    }
    inner = inner.first < inner.last ? inner : RowSpan{whole.last, whole.last};
    paint_row(picture, y, {whole.first, inner.first}, plane, paint.edge, paint.tested);
    paint_row(picture, y, inner, plane, paint.fill, paint.tested);
    paint_row(picture, y, {inner.last, whole.last}, plane, paint.edge, paint.tested);
  }
}
// [fill_polygon]

} // namespace cookbook
