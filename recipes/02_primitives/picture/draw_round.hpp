#pragma once

/// \file
/// \brief Spheres and capsules in a picture: the ray of each pixel meets them exactly.

#include "02_primitives/picture/draw_flat.hpp"

#include <cmath>
#include <optional>

namespace cookbook
{

/// The rays of all pixels in the camera's frame: at(x, y) + z · along(x, y) has this z.
///
/// Both are linear in the pixel, also without perspective.
struct LensRays
{
  Matrix4<double> projection; ///< from the camera to clip space
  double width;               ///< [drawn pixels]
  double height;              ///< [drawn pixels]
};

/// A line along which z grows by one a step: at + z · along.
struct LensRay
{
  Vector3<double> at;    ///< [m] where z is 0
  Vector3<double> along; ///< z is 1
};

/// The line of all points that are seen at (x, y) [drawn pixels].
inline LensRay lens_ray(const LensRays& rays, double x, double y)
{
  const Matrix4<double>& m = rays.projection;
  const double u = 2 * x / rays.width - 1, v = 1 - 2 * y / rays.height;
  return {
      {(u * m(3, 3) - m(0, 3)) / m(0, 0), (v * m(3, 3) - m(1, 3)) / m(1, 1), 0},
      {(u * m(3, 2) - m(0, 2)) / m(0, 0), (v * m(3, 2) - m(1, 2)) / m(1, 1), 1}};
}

/// The depth of what has this z in the camera's frame.
inline double depth_at(const Matrix4<double>& m, double z)
{
  return (m(2, 2) * z + m(2, 3)) / (m(3, 2) * z + m(3, 3));
}

/// The z at which a lens's line first meets a sphere, c and all in the camera's frame: the greater
/// root of |at + z along − c|² = r².
inline std::optional<double> first_z(const LensRay& ray, const Vector3<double>& c, double radius)
{
  const Vector3<double> from = ray.at - c;
  const double a = ray.along.squaredNorm(), b = ray.along.dot(from);
  const Vector3<double> beside = from - b / a * ray.along; // from the centre to the line
  const double under_root = radius * radius - beside.squaredNorm();
  if (!(under_root >= 0))
  {
    return std::nullopt;
  }
  return (-b + std::sqrt(under_root * a)) / a;
}

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

/// What makes the pixels of a sphere.
struct BallPaint
{
  Matrix3<double> to_body;       ///< from the camera's axes to the body's
  Vector3<double> light;         ///< [1] unit, in the camera's frame
  std::array<Colour, 2> colours; ///< of its eight parts, by turns
  double ambient;                ///< [1] brightness out of the light
  double rim; ///< squared cosine of the angle to the view below which it is drawn dark
};

/// The colour at a point of a sphere: `n` is the unit normal, `along` the line to it, both in the
/// camera's frame.
inline Colour
ball_colour(const BallPaint& paint, const Vector3<double>& n, const Vector3<double>& along)
{
  const Vector3<double> q = paint.to_body * n;
  const bool odd = (q.x() > 0) != ((q.y() > 0) != (q.z() > 0));
  const double facing = n.dot(along);
  const bool rim = facing * facing < paint.rim * along.squaredNorm();
  const double light = paint.ambient + (1 - paint.ambient) * std::max(0.0, n.dot(paint.light));
  return lit(paint.colours[odd ? 1 : 0], rim ? light * 0.6 : light);
}

/// Draws a sphere whose eight parts, made by the planes of the body's axes, have two shades by
/// turns, so that its turning is seen; `axes` are the body's axes in the world.
inline void draw_sphere(
    Picture& picture, const Camera<double>& camera, const Sphere<double>& sphere,
    const Matrix3<double>& axes, const Colour& colour, const Light& light = {})
{
  const Isometry3<double> to_camera = rigid_inverse(camera.pose);
  const Vector3<double> c = to_camera * sphere.center;
  const LensRays rays{
      camera.projection, static_cast<double>(picture.width), static_cast<double>(picture.height)};
  const PixelRect rect = covered(picture, camera.projection, c, sphere.radius);
  const double pixels = (rect.x1 - rect.x0 + 1) / 2.0;
  const BallPaint paint{
      axes.transpose() * camera.pose.linear(),
      to_camera.linear() * light.towards,
      {colour, lit(colour, 0.8)},
      light.ambient,
      std::min(0.15, 2 * picture.samples / pixels)};
  for (int y = rect.y0; y < rect.y1; ++y)
  {
    for (int x = rect.x0; x < rect.x1; ++x)
    {
      const LensRay ray = lens_ray(rays, x + 0.5, y + 0.5);
      const std::optional<double> z = first_z(ray, c, sphere.radius);
      const double depth = z ? depth_at(camera.projection, *z) : 1;
      const std::size_t at = row_start(picture, y) + static_cast<std::size_t>(x);
      if (z && depth >= -1 && static_cast<float>(depth) < picture.depth[at])
      {
        const Vector3<double> n = (ray.at + *z * ray.along - c) / sphere.radius;
        picture.depth[at] = static_cast<float>(depth);
        picture.pixels[at] = to_pixel(ball_colour(paint, n, ray.along));
      }
    }
  }
}

} // namespace cookbook
