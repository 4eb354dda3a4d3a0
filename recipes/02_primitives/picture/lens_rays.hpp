#pragma once

/// \file
/// \brief The lines of sight of all pixels, where one meets a sphere, and the pixels a sphere may
/// cover.

#include "02_primitives/camera/camera.hpp"
#include "02_primitives/picture/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

// [lens_rays]
/// A line in the camera's frame: at z · along + at.
struct LensRay
{
  Vector3<double> at;    ///< [m] where z is 0
  Vector3<double> along; ///< along which z grows by 1
};

/// The lines of all points that are seen at one pixel each: linear in the pixel's x and y.
struct LensRays
{
  LensRay corner; ///< of the picture's upper left corner
  LensRay per_x;  ///< what a pixel to the right adds
  LensRay per_y;  ///< what a pixel down adds
};

/// The lines of a lens, for a picture of width × height drawn pixels; P26.
inline LensRays lens_rays(const Matrix4<double>& m, double width, double height)
{
  const auto line = [&m](double x, double y, double w) -> LensRay
  {
    return {
        {(x * m(3, 3) - w * m(0, 3)) / m(0, 0), (y * m(3, 3) - w * m(1, 3)) / m(1, 1), 0},
        {(x * m(3, 2) - w * m(0, 2)) / m(0, 0), (y * m(3, 2) - w * m(1, 2)) / m(1, 1), w}};
  };
  return {line(-1, 1, 1), line(2 / width, 0, 0), line(0, -2 / height, 0)};
}
// [lens_rays]

/// The line of all points that are seen at (x, y) [drawn pixels].
inline LensRay lens_ray(const LensRays& rays, double x, double y)
{
  return {
      rays.corner.at + x * rays.per_x.at + y * rays.per_y.at,
      rays.corner.along + x * rays.per_x.along + y * rays.per_y.along};
}

/// The depth of what has this z in the camera's frame.
inline double depth_at(const Matrix4<double>& m, double z)
{
  return (m(2, 2) * z + m(2, 3)) / (m(3, 2) * z + m(3, 3));
}

// [first_z]
/// The z at which a lens's line first meets a sphere, c and all in the camera's frame: the greater
/// root of |at + z along − c|² = r².
inline std::optional<double> first_z(const LensRay& ray, const Vector3<double>& c, double radius)
{
  const Vector3<double> from = ray.at - c;
  const double a = ray.along.squaredNorm(), b = ray.along.dot(from) / a;
  const Vector3<double> beside = from - b * ray.along; // from the centre to the line
  const double under_root = radius * radius - beside.squaredNorm();
  if (!(under_root >= 0))
  {
    return std::nullopt;
  }
  return std::sqrt(under_root / a) - b;
}
// [first_z]

/// A rectangle of pixels: from x0, y0 to before x1, y1.
struct PixelRect
{
  int x0 = 0; ///< its first column
  int y0 = 0; ///< its first row
  int x1 = 0; ///< the column after its last
  int y1 = 0; ///< the row after its last
};

/// The pixels that a sphere may cover: those of a box around it that faces the camera.
///
/// All of the picture if the box reaches behind the near plane, none if it is all behind it.
inline PixelRect
covered(const Picture& picture, const Matrix4<double>& m, const Vector3<double>& c, double radius)
{
  double x0 = picture.width, y0 = picture.height, x1 = 0, y1 = 0;
  int ahead = 0;
  for (unsigned i = 0; i < 8; ++i)
  {
    const auto side = [i, radius](unsigned bit) { return i & bit ? radius : -radius; };
    const Vector<double, 4> p =
        m * Vector<double, 4>(c.x() + side(1), c.y() + side(2), c.z() + side(4), 1);
    if (!p.allFinite())
    {
      return {};
    }
    if (!(p.z() + p.w() > 0) || !(p.w() > 0))
    {
      continue;
    }
    ++ahead;
    const double x = (1 + p.x() / p.w()) / 2 * picture.width;
    const double y = (1 - p.y() / p.w()) / 2 * picture.height;
    x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
  }
  if (ahead < 8)
  {
    return ahead == 0 ? PixelRect{} : PixelRect{0, 0, picture.width, picture.height};
  }
  const auto within = [](double x, int most)
  { return static_cast<int>(std::min(std::max(x, 0.0), static_cast<double>(most))); };
  return {
      within(x0, picture.width), within(y0, picture.height), within(x1 + 1, picture.width),
      within(y1 + 1, picture.height)};
}

} // namespace cookbook
