#pragma once

/// \file
/// \brief Polygons, triangles and boxes of the world in a picture: clipped, projected, filled.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/picture/raster.hpp"

#include <cmath>
#include <span>

namespace cookbook
{

// [light]
/// Where the light comes from, and how bright it is.
struct Light
{
  Vector3<double> towards{-0.48, 0.8, 0.36}; ///< [1] unit, world, from a body to the light
  double ambient = 0.7;                      ///< [1] brightness of a face that the light misses
  double direct = 0.4;                       ///< [1] what a face adds that looks into the light
};

/// How bright a surface with this unit normal is: Lambert's cosine law.
inline double brightness(const Light& light, const Vector3<double>& normal)
{
  return light.ambient + light.direct * std::max(0.0, normal.dot(light.towards));
}
// [light]

/// Corners with a fourth coordinate: in the world it is 1, in clip space W.
using ClipPolygon = CornerList<Vector<double, 4>>;

// [clipped]
/// The part of a polygon with plane · corner ≥ 0: Sutherland and Hodgman's clipping.
inline ClipPolygon clipped(const ClipPolygon& polygon, const Vector<double, 4>& plane)
{
  ClipPolygon kept;
  for (std::size_t i = 0; i < polygon.size; ++i)
  {
    const Vector<double, 4>&a = polygon.points[i],
                         &b = polygon.points[i + 1 == polygon.size ? 0 : i + 1];
    const double at_a = plane.dot(a), at_b = plane.dot(b);
    if (at_a >= 0)
    {
      kept.add(a);
    }
    if (at_a >= 0 && at_b < 0) // from the inside out, so that faces cut a common edge alike
    {
      kept.add(a + at_a / (at_a - at_b) * (b - a));
    }
    if (at_a < 0 && at_b >= 0)
    {
      kept.add(b + at_b / (at_b - at_a) * (a - b));
    }
  }
  return kept;
}
// [clipped]

/// The planes at which clip space is cut: near, and left, right, below and above at four times the
/// picture, so that coordinates stay small; beside the picture itself nothing needs a cut.
inline std::array<Vector<double, 4>, 5> view_cuts()
{
  return {{{0, 0, 1, 1}, {1, 0, 0, 4}, {-1, 0, 0, 4}, {0, 1, 0, 4}, {0, -1, 0, 4}}};
}

// [on_screen]
/// The corners in the picture of what is ahead of the camera; none if a number is not finite.
inline ScreenPolygon
on_screen(const Picture& picture, const Matrix4<double>& clip_from_world, const ClipPolygon& world)
{
  ClipPolygon clip;
  for (std::size_t i = 0; i < world.size; ++i)
  {
    clip.add(clip_from_world * world.points[i]);
  }
  for (const Vector<double, 4>& cut : view_cuts())
  {
    clip = clipped(clip, cut);
  }
  ScreenPolygon screen;
  for (std::size_t i = 0; i < clip.size; ++i)
  {
    const Vector<double, 4>& p = clip.points[i];
    const Vector3<double> ndc = p.head<3>() / (p.w() > 0 ? p.w() : 1);
    if (!(p.w() > 0) || !ndc.allFinite())
    {
      return {};
    }
    screen.add({(1 + ndc.x()) / 2 * picture.width, (1 - ndc.y()) / 2 * picture.height, ndc.z()});
  }
  return screen;
}
// [on_screen]

/// Points of the world as corners.
inline ClipPolygon corners_of(std::span<const Vector3<double>> points)
{
  ClipPolygon corners;
  for (const Vector3<double>& p : points)
  {
    corners.add({p.x(), p.y(), p.z(), 1});
  }
  return corners;
}

/// The same polygon, turning the other way.
inline ScreenPolygon reversed(const ScreenPolygon& polygon)
{
  ScreenPolygon other;
  for (std::size_t i = polygon.size; i-- > 0;)
  {
    other.add(polygon.points[i]);
  }
  return other;
}

/// Draws a plane convex polygon with at most 40 corners, seen from either side.
inline void draw_polygon(
    Picture& picture, const Camera<double>& camera, std::span<const Vector3<double>> corners,
    const Paint& paint)
{
  const ScreenPolygon screen = on_screen(picture, clip_from_world(camera), corners_of(corners));
  const DepthPlane depth = depth_plane(screen);
  fill_polygon(picture, screen, depth, paint);
  fill_polygon(picture, reversed(screen), depth, paint);
}

/// Draws a triangle, seen from either side, in this colour.
inline void draw_triangle(
    Picture& picture, const Camera<double>& camera, const Triangle<double>& triangle,
    const Colour& colour)
{
  const std::array<Vector3<double>, 3> corners{triangle.a, triangle.b, triangle.c};
  draw_polygon(picture, camera, corners, {colour});
}

/// The corners of a box's face on the side of `sign` along `axis`, clockwise from outside.
inline std::array<Vector3<double>, 4> face_corners(const Obb<double>& box, int axis, double sign)
{
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  const Vector3<double> middle = box.center + sign * box.half_extents[axis] * box.axes.col(axis);
  const Vector3<double> u = sign * box.half_extents[j] * box.axes.col(j);
  const Vector3<double> v = box.half_extents[k] * box.axes.col(k);
  return {middle - u - v, middle - u + v, middle + u + v, middle + u - v};
}

/// The longest a box's edges may be drawn wide [drawn pixels]: a twelfth of its face's shortest
/// side.
inline double edge_width(const ScreenPolygon& face, double pixels)
{
  double least = pixels * 12;
  for (std::size_t i = 0; i < face.size; ++i)
  {
    const Vector3<double> along = face.points[(i + 1) % face.size] - face.points[i];
    least = std::min(least, along.head<2>().norm());
  }
  return least / 12;
}

// [draw_box]
/// Draws a box: each face in the light that falls on it, its edges darker.
inline void draw_box(
    Picture& picture, const Camera<double>& camera, const Obb<double>& box, const Colour& colour,
    const Light& light = {})
{
  const Matrix4<double> clip = clip_from_world(camera);
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const double sign = face % 2 == 0 ? 1 : -1;
    const ScreenPolygon screen =
        on_screen(picture, clip, corners_of(face_corners(box, axis, sign)));
    const Colour fill = lit(colour, brightness(light, sign * box.axes.col(axis)));
    const double width = edge_width(screen, 1.0 * picture.samples);
    fill_polygon(picture, screen, depth_plane(screen), {fill, lit(fill, 0.6), width});
  }
}
// [draw_box]

} // namespace cookbook
