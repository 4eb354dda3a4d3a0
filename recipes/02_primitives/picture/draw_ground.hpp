#pragma once

/// \file
/// \brief A floor with a grid, and the shadows of bodies on it.

#include "02_primitives/picture/draw_marks.hpp"

#include <cmath>

namespace cookbook
{

/// A floor: a box whose top, the side of its y axis, is drawn; its top is at y = `height`.
inline Obb<double> floor_at(double height, double half_extent)
{
  return {{0, height - 0.5, 0}, Matrix3<double>::Identity(), {half_extent, 0.5, half_extent}};
}

/// The top of a floor in the picture.
inline ScreenPolygon
floor_on_screen(const Picture& picture, const Camera<double>& camera, const Obb<double>& floor)
{
  return on_screen(picture, clip_from_world(camera), corners_of(face_corners(floor, 1, 1)));
}

/// Whether the camera is above the plane through a point with this normal.
inline bool sees_front(
    const Camera<double>& camera, const Vector3<double>& point, const Vector3<double>& normal)
{
  const bool from_the_eye = camera.projection(3, 2) != 0;
  const Vector3<double> back = camera.pose.linear().col(2);
  return normal.dot(from_the_eye ? camera.pose.translation() - point : back) > 0;
}

/// The same plane, nearer by this many millionths of the depths: for what lies on a face.
inline DepthPlane nearer(DepthPlane plane, double millionths)
{
  const double by = millionths * 1e-6;
  plane.at_zero -= by;
  plane.least -= by;
  plane.most -= by;
  return plane;
}

/// Draws the line of a floor's grid between two points of its top.
inline void draw_grid_line(
    Picture& picture, const Camera<double>& camera, const Segment<double>& line,
    const DepthPlane& plane, const Colour& colour)
{
  if (const auto ends = segment_on_screen(picture, camera, line))
  {
    fill_polygon(
        picture, line_corners((*ends)[0], (*ends)[1], picture.samples), nearer(plane, 1), {colour});
  }
}

/// Draws the top of a box as a floor, with a line every `cell` [m] from its middle on; from below,
/// nothing. A cell of 0, or one that makes more than a thousand lines, is no grid.
inline void draw_ground(
    Picture& picture, const Camera<double>& camera, const Obb<double>& floor,
    const Palette& palette, double cell = 1)
{
  const ScreenPolygon top = floor_on_screen(picture, camera, floor);
  const DepthPlane plane = depth_plane(top);
  const Vector3<double> middle = floor.center + floor.half_extents.y() * floor.axes.col(1);
  if (!sees_front(camera, middle, floor.axes.col(1)))
  {
    return;
  }
  fill_polygon(picture, top, plane, {palette.ground});
  for (const int axis : {0, 2})
  {
    const Vector3<double> across = floor.axes.col(axis), along = floor.axes.col(2 - axis);
    const double half = floor.half_extents[axis], reach = floor.half_extents[2 - axis];
    const int lines = cell > 0 && half / cell < 500 ? static_cast<int>(half / cell) : -1;
    for (int i = -lines; i <= lines; ++i)
    {
      const Vector3<double> at = middle + i * cell * across;
      draw_grid_line(
          picture, camera, {at - reach * along, at + reach * along}, plane, palette.grid);
    }
  }
}

// [shadow_of]
/// Where the light's rays through a polygon's corners meet a floor: the part of the polygon above
/// the floor, moved along the light, and cut at the floor's four sides.
inline ClipPolygon
shadow_of(const ClipPolygon& polygon, const Obb<double>& floor, const Light& light)
{
  const Vector3<double> n = floor.axes.col(1);
  const double top = n.dot(floor.center) + floor.half_extents.y(), towards = n.dot(light.towards);
  if (!(towards > 0))
  {
    return {};
  }
  ClipPolygon shadow = clipped(polygon, {n.x(), n.y(), n.z(), -top});
  for (std::size_t i = 0; i < shadow.size; ++i)
  {
    const Vector3<double> p = shadow.points[i].head<3>();
    shadow.points[i].head<3>() = p - (n.dot(p) - top) / towards * light.towards;
  }
  for (const int axis : {0, 2})
  {
    const Vector3<double> u = floor.axes.col(axis);
    const double middle = u.dot(floor.center), half = floor.half_extents[axis];
    shadow = clipped(shadow, {u.x(), u.y(), u.z(), half - middle});
    shadow = clipped(shadow, {-u.x(), -u.y(), -u.z(), half + middle});
  }
  return shadow;
}
// [shadow_of]

// [lay_shadow]
/// Lays a shadow on a floor that is drawn already, once: its depth is a little nearer, and what has
/// that depth is not darkened again.
inline void lay_shadow(
    Picture& picture, const Camera<double>& camera, const ClipPolygon& shadow,
    const Obb<double>& floor, const Colour& colour)
{
  const Vector3<double> up = floor.axes.col(1);
  if (!sees_front(camera, floor.center + floor.half_extents.y() * up, up))
  {
    return;
  }
  const DepthPlane plane = nearer(depth_plane(floor_on_screen(picture, camera, floor)), 2);
  const ScreenPolygon screen = on_screen(picture, clip_from_world(camera), shadow);
  fill_polygon(picture, screen, plane, {colour});
  fill_polygon(picture, reversed(screen), plane, {colour});
}
// [lay_shadow]

/// Draws a box's shadow on a floor that is drawn already: that of the faces in the light.
inline void draw_shadow(
    Picture& picture, const Camera<double>& camera, const Obb<double>& floor,
    const Obb<double>& box, const Colour& colour, const Light& light = {})
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const double sign = box.axes.col(axis).dot(light.towards) > 0 ? 1 : -1;
    const ClipPolygon face = corners_of(face_corners(box, axis, sign));
    lay_shadow(picture, camera, shadow_of(face, floor, light), floor, colour);
  }
}

/// Draws a sphere's shadow: that of the disc across the light, as a polygon of 32 corners.
inline void draw_shadow(
    Picture& picture, const Camera<double>& camera, const Obb<double>& floor,
    const Sphere<double>& sphere, const Colour& colour, const Light& light = {})
{
  const Vector3<double> u = sphere.radius * any_right(light.towards);
  const Vector3<double> v = light.towards.cross(u);
  std::array<Vector3<double>, 32> disc;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const double t = static_cast<double>(i) / 8; // a quarter turn: (1 − t², 2t) / (1 + t²)
    const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    disc[i] = sphere.center + c * u + s * v;
    disc[i + 8] = sphere.center - s * u + c * v;
    disc[i + 16] = sphere.center - c * u - s * v;
    disc[i + 24] = sphere.center + s * u - c * v;
  }
  lay_shadow(picture, camera, shadow_of(corners_of(disc), floor, light), floor, colour);
}

/// Draws a capsule's shadow: those of its ends, and of the strip between them across the light.
inline void draw_shadow(
    Picture& picture, const Camera<double>& camera, const Obb<double>& floor,
    const Capsule<double>& capsule, const Colour& colour, const Light& light = {})
{
  const auto& [a, b] = capsule.segment;
  const Vector3<double> beside =
      capsule.radius * perpendicular_to_both(light.towards, Vector3<double>(b - a));
  const std::array<Vector3<double>, 4> strip{a - beside, b - beside, b + beside, a + beside};
  lay_shadow(picture, camera, shadow_of(corners_of(strip), floor, light), floor, colour);
  draw_shadow(picture, camera, floor, Sphere<double>{a, capsule.radius}, colour, light);
  draw_shadow(picture, camera, floor, Sphere<double>{b, capsule.radius}, colour, light);
}

} // namespace cookbook
