#pragma once

/// \file
/// \brief A camera that circles a target, and what a pointer does with it.

#include "02_primitives/camera/camera.hpp"
#include "common/math/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cookbook
{

// [orbit]
/// A camera's place on a sphere around what it looks at.
struct Orbit
{
  Vector3<double> target{0, 0, 0}; ///< [m], world
  double distance = 10;            ///< [m] from the target
  double yaw = 0.6;    ///< [rad] about y; 0 looks along −z, above 0 stands to the right
  double pitch = 0.35; ///< [rad] above the horizon
  double angle = 0.8;  ///< [rad] the lens, from the lower to the upper edge
};

/// The camera of an orbit, for a picture of width × height shown pixels.
///
/// It keeps what is from a hundredth of the distance to a hundred distances ahead. For a picture
/// without a size, or an orbit that makes no lens, it has the lens of a square picture.
inline Camera<double> orbit_camera(const Orbit& orbit, int width, int height)
{
  const SineCosine<double> yaw = sine_cosine(orbit.yaw), pitch = sine_cosine(orbit.pitch);
  const Vector3<double> back(pitch.cosine * yaw.sine, pitch.sine, pitch.cosine * yaw.cosine);
  const Vector3<double> eye = orbit.target + orbit.distance * back;
  const double w = std::max(width, 1), h = std::max(height, 1), d = orbit.distance;
  const std::optional<Matrix4<double>> lens =
      perspective<double>(orbit.angle, w / h, d / 100, d * 100);
  return {
      look_at<double>(eye, orbit.target, {0, 1, 0}),
      lens.value_or(perspective<double>(0.8, w / h, 0.1, 1000).value()),
      {w, h}};
}
// [orbit]

/// Turns an orbit as a pointer that moves by dx, dy [pixels] drags what is seen: a turn is 600
/// pixels; the pitch stays below a right angle.
inline void turn(Orbit& orbit, double dx, double dy)
{
  constexpr double per_pixel = 6.283185307179586 / 600;
  orbit.yaw -= dx * per_pixel;
  orbit.pitch = std::clamp(orbit.pitch + dy * per_pixel, -1.55, 1.55);
}

/// Moves an orbit nearer (a factor below one) or away from its target, from a centimetre to 10 km.
inline void zoom(Orbit& orbit, double factor)
{
  orbit.distance = std::clamp(orbit.distance * factor, 0.01, 10'000.0);
}

// [drag_point]
/// The point under a pixel in the plane through `point` that faces the camera; nothing where the
/// pixel's ray does not meet it ahead.
inline std::optional<Vector3<double>>
drag_point(const Camera<double>& camera, const Vector2<double>& pixel, const Vector3<double>& point)
{
  const Ray<double> ray = picking_ray(camera, pixel);
  const Vector3<double> ahead = -camera.pose.linear().col(2);
  const double closing = ahead.dot(ray.direction), t = ahead.dot(point - ray.origin) / closing;
  if (!(closing > 0) || !(t >= 0) || !std::isfinite(t))
  {
    return std::nullopt;
  }
  return ray.origin + t * ray.direction;
}
// [drag_point]

} // namespace cookbook
