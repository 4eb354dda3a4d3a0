#pragma once

/// \file
/// \brief Lines, dots and arrows in a picture, as wide as asked for at any distance.

#include "02_primitives/picture/draw_flat.hpp"

#include <cmath>
#include <optional>

namespace cookbook
{

/// Whether what is nearer hides a mark.
enum class Cover
{
  by_depth, ///< what is nearer hides it
  none      ///< it is drawn over everything
};

/// The part of a segment that is ahead of the camera, in the picture; nothing if none of it is.
inline std::optional<std::array<Vector3<double>, 2>> segment_on_screen(
    const Picture& picture, const Camera<double>& camera, const Segment<double>& segment)
{
  const std::array<Vector3<double>, 2> ends{segment.start, segment.end};
  const ScreenPolygon screen = on_screen(picture, clip_from_world(camera), corners_of(ends));
  if (screen.size < 2)
  {
    return std::nullopt;
  }
  // Of a segment that is cut, clipping returns the cut twice: take the two farthest from each
  // other.
  std::array<Vector3<double>, 2> kept{screen.points[0], screen.points[1]};
  for (std::size_t i = 2; i < screen.size; ++i)
  {
    const Vector3<double>& p = screen.points[i];
    if ((p - kept[0]).head<2>().squaredNorm() > (kept[1] - kept[0]).head<2>().squaredNorm())
    {
      kept[1] = p;
    }
  }
  return kept;
}

/// The four corners of a line from a to b in the picture, `width` [drawn pixels] wide; clockwise.
inline ScreenPolygon line_corners(const Vector3<double>& a, const Vector3<double>& b, double width)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), length = std::sqrt(dx * dx + dy * dy);
  const double scale = length > 0 ? width / 2 / length : 0;
  const Vector3<double> beside(-dy * scale, dx * scale, 0);
  ScreenPolygon line;
  line.add(a - beside);
  line.add(b - beside);
  line.add(b + beside);
  line.add(a + beside);
  return line;
}

/// The depth along a line in the picture, the same across it.
inline DepthPlane depth_along(const Vector3<double>& a, const Vector3<double>& b)
{
  const double dx = b.x() - a.x(), dy = b.y() - a.y(), squared = dx * dx + dy * dy;
  const double rise = squared > 0 ? (b.z() - a.z()) / squared : 0;
  return {
      a.z() - rise * (dx * a.x() + dy * a.y()), rise * dx, rise * dy, std::min(a.z(), b.z()),
      std::max(a.z(), b.z())};
}

/// Draws a segment `pixels` [shown pixels] wide.
inline void draw_segment(
    Picture& picture, const Camera<double>& camera, const Segment<double>& segment,
    const Colour& colour, double pixels = 1.5, Cover cover = Cover::by_depth)
{
  if (const auto ends = segment_on_screen(picture, camera, segment))
  {
    const auto& [a, b] = *ends;
    fill_polygon(
        picture, line_corners(a, b, pixels * picture.samples), depth_along(a, b),
        {colour, colour, 0, cover == Cover::by_depth});
  }
}

/// The sixteen corners of a dot in the picture, clockwise: rational points of the circle.
inline ScreenPolygon dot_corners(const Vector3<double>& at, double radius)
{
  ScreenPolygon dot;
  for (int i = 0; i < 16; ++i)
  {
    const double t = (i % 4) / 4.0; // a quarter turn: (1 − t², 2t) / (1 + t²)
    const double c = radius * (1 - t * t) / (1 + t * t), s = radius * 2 * t / (1 + t * t);
    const std::array<Vector3<double>, 4> turned{{{c, s, 0}, {-s, c, 0}, {-c, -s, 0}, {s, -c, 0}}};
    dot.add(at + turned[static_cast<std::size_t>(i / 4)]);
  }
  return dot;
}

/// Draws a dot of this radius [shown pixels] at a point.
inline void draw_dot(
    Picture& picture, const Camera<double>& camera, const Vector3<double>& point,
    const Colour& colour, double pixels = 3, Cover cover = Cover::by_depth)
{
  if (const auto ends = segment_on_screen(picture, camera, {point, point}))
  {
    const Vector3<double>& at = ends->front();
    const double size = std::min(pixels, 1000.0) * picture.samples;
    fill_polygon(
        picture, dot_corners(at, size), depth_along(at, at),
        {colour, lit(colour, 0.6), 1.0 * picture.samples, cover == Cover::by_depth});
  }
}

/// Draws an arrow from `start` along `vector` [m], e.g. a normal or an impulse; one without a
/// length is a dot.
inline void draw_arrow(
    Picture& picture, const Camera<double>& camera, const Vector3<double>& start,
    const Vector3<double>& vector, const Colour& colour, double pixels = 2,
    Cover cover = Cover::by_depth)
{
  const auto ends = segment_on_screen(picture, camera, {start, start + vector});
  if (!ends)
  {
    return;
  }
  const auto& [a, b] = *ends;
  const double length = (b - a).head<2>().norm(), wide = pixels * picture.samples;
  if (!(length > wide))
  {
    draw_dot(picture, camera, start, colour, pixels, cover);
    return;
  }
  const Vector3<double> neck = b - std::min(1.0, 4.5 * wide / length) * (b - a);
  const ScreenPolygon base = line_corners(neck, b, 3.5 * wide);
  ScreenPolygon head;
  head.add(base.points[0]);
  head.add(b);
  head.add(base.points[3]);
  const Paint paint{colour, colour, 0, cover == Cover::by_depth};
  fill_polygon(picture, line_corners(a, neck, wide), depth_along(a, b), paint);
  fill_polygon(picture, head, depth_along(a, b), paint);
}

} // namespace cookbook
