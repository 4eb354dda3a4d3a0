#pragma once

/// \file
/// \brief Spheres and capsules in a picture: the ray of each pixel meets them exactly.

#include "02_primitives/picture/draw_flat.hpp"
#include "02_primitives/picture/lens_rays.hpp"

#include <optional>

namespace cookbook
{

/// What a line meets first, in the camera's frame.
struct RoundHit
{
  double z;               ///< [m] where on the line
  Vector3<double> normal; ///< [1] unit, out of the surface
  bool second;            ///< in the second of the two shades
};

/// Draws what the lines of the pixels in `rect` meet: `first_hit` takes a line of the camera's
/// frame to an optional `RoundHit`. A rim some two pixels wide is darker.
template <class FirstHit>
void draw_by_ray(
    Picture& picture, const Camera<double>& camera, const PixelRect& rect, const Colour& colour,
    const Light& light, const FirstHit& first_hit)
{
  const LensRays rays = lens_rays(camera.projection, picture.width, picture.height);
  const Vector3<double> towards = camera.pose.linear().transpose() * light.towards;
  const Light seen{towards, light.ambient, light.direct};
  const std::array<Colour, 2> shades{colour, lit(colour, 0.8)};
  const double rim = std::min(0.15, 4.0 * picture.samples / (rect.x1 - rect.x0 + 1));
  for (int y = rect.y0; y < rect.y1; ++y)
  {
    for (int x = rect.x0; x < rect.x1; ++x)
    {
      const LensRay ray = lens_ray(rays, x + 0.5, y + 0.5);
      const std::optional<RoundHit> hit = first_hit(ray);
      const double depth = hit ? depth_at(camera.projection, hit->z) : 1;
      const std::size_t at = row_start(picture, y) + static_cast<std::size_t>(x);
      if (depth >= -1 && static_cast<float>(depth) < picture.depth[at])
      {
        const double facing = hit->normal.dot(ray.along);
        const bool dark = facing * facing < rim * ray.along.squaredNorm();
        const double shade = brightness(seen, hit->normal) * (dark ? 0.65 : 1);
        picture.depth[at] = static_cast<float>(depth);
        picture.pixels[at] = to_pixel(lit(shades[hit->second ? 1 : 0], shade));
      }
    }
  }
}

/// Draws a sphere whose eight parts, made by the planes of the body's axes, have two shades by
/// turns, so that its turning is seen; `axes` are the body's axes in the world.
inline void draw_sphere(
    Picture& picture, const Camera<double>& camera, const Sphere<double>& sphere,
    const Matrix3<double>& axes, const Colour& colour, const Light& light = {})
{
  const Vector3<double> c = rigid_inverse(camera.pose) * sphere.center;
  const Matrix3<double> to_body = axes.transpose() * camera.pose.linear();
  const double r = sphere.radius;
  const auto first_hit = [&](const LensRay& ray) -> std::optional<RoundHit>
  {
    const std::optional<double> z = first_z(ray, c, r);
    if (!z)
    {
      return std::nullopt;
    }
    const Vector3<double> n = (ray.at + *z * ray.along - c) / r, q = to_body * n;
    return RoundHit{*z, n, (q.x() > 0) != ((q.y() > 0) != (q.z() > 0))};
  };
  const PixelRect rect = r > 0 ? covered(picture, camera.projection, c, r) : PixelRect{};
  draw_by_ray(picture, camera, rect, colour, light, first_hit);
}

/// The z at which a line first meets the side of a cylinder without ends: `from` is its point at z
/// 0 from a point of the axis, `u` the axis's unit direction.
inline std::optional<double> first_z_of_side(
    const Vector3<double>& from, const Vector3<double>& along, const Vector3<double>& u,
    double radius)
{
  // A sphere in the plane across the axis.
  const Vector3<double> across = along - along.dot(u) * u;
  return across.squaredNorm() > 0 ? first_z({from - from.dot(u) * u, across}, {0, 0, 0}, radius)
                                  : std::nullopt;
}

/// Draws a capsule, its two halves in two shades.
inline void draw_capsule(
    Picture& picture, const Camera<double>& camera, const Capsule<double>& capsule,
    const Colour& colour, const Light& light = {})
{
  const Isometry3<double> to_camera = rigid_inverse(camera.pose);
  const Vector3<double> a = to_camera * capsule.segment.start, b = to_camera * capsule.segment.end;
  const double length = (b - a).norm(), r = capsule.radius;
  const Vector3<double> u =
      length > 0 ? Vector3<double>((b - a) / length) : Vector3<double>(0, 1, 0);
  const auto first_hit = [&](const LensRay& ray) -> std::optional<RoundHit>
  {
    const Vector3<double> from = ray.at - a;
    std::optional<double> z = first_z_of_side(from, ray.along, u, r);
    double s = z ? u.dot(from + *z * ray.along) : -1;
    if (!(s >= 0 && s <= length)) // not on the side: on one of the ends, if at all
    {
      const std::optional<double> at_a = first_z(ray, a, r), at_b = first_z(ray, b, r);
      z = !at_a || (at_b && *at_b > *at_a) ? at_b : at_a;
      s = z && z == at_b ? length : 0;
    }
    if (!z)
    {
      return std::nullopt;
    }
    const Vector3<double> n = (from + *z * ray.along - s * u) / r;
    return RoundHit{*z, n, 2 * u.dot(from + *z * ray.along) > length};
  };
  const PixelRect rect =
      r > 0 ? covered(picture, camera.projection, (a + b) / 2, length / 2 + r) : PixelRect{};
  draw_by_ray(picture, camera, rect, colour, light, first_hit);
}

} // namespace cookbook
