#pragma once

/// \file
/// \brief Bodies as outlines in pixels, as they are seen.

#include "06_world/scene_figures/trial/scene_figures.hpp"

#include <array>
#include <cmath>

namespace cookbook
{

/// The axes of the picture in the world, as rows: right, up, towards the viewer.
inline Matrix3<double> picture_axes(double yaw, double pitch)
{
  const double cy = std::cos(yaw), sy = std::sin(yaw);
  const double cp = std::cos(pitch), sp = std::sin(pitch);
  Matrix3<double> axes;
  axes << cy, 0, -sy, -sy * sp, cp, -cy * sp, sy * cp, sp, cy * cp;
  return axes;
}

/// From the world to the pixels of a picture, y down.
struct Projection
{
  Matrix3<double> axes;   ///< of the picture, as rows
  Eigen::Vector2d corner; ///< [m], upper left, right and up as seen
  double scale;           ///< [pixels/m]
  double top;             ///< [pixels] above the picture: its title

  /// Where a point of the world is seen.
  Eigen::Vector2d operator()(const Vector3<double>& world) const
  {
    const Vector3<double> seen = axes * world;
    return {scale * (seen.x() - corner.x()), top + scale * (corner.y() - seen.y())};
  }
};

/// Points in tenths of a pixel, x and y in turn: four for each face of a box that is seen; for a
/// ball its centre, and the tip of the spoke that shows how it is turned. Empty: not to be seen.
using Outline = std::vector<long>;

/// Tenths of a pixel, rounded in two steps so that the last bit of a sine cannot turn a tie.
inline long tenths(double pixels)
{
  const long millionths = std::lround(pixels * 1e6);
  const long rounded = (std::abs(millionths) + 50'000) / 100'000;
  return millionths < 0 ? -rounded : rounded;
}

/// Adds a point to an outline.
inline void add_point(Outline& outline, const Eigen::Vector2d& pixel)
{
  outline.push_back(tenths(pixel.x()));
  outline.push_back(tenths(pixel.y()));
}

/// The faces of a box that are seen; those seen from nearly along them are left out.
inline Outline
box_outline(const Vector3<double>& half_extents, const BodyState& state, const Projection& project)
{
  constexpr double edge_on = 0.005;
  const Matrix3<double> axes = state.orientation.toRotationMatrix();
  const Matrix3<double> halves = axes * half_extents.asDiagonal();
  Outline outline;
  for (int i = 0; i < 3; ++i)
  {
    const double towards = project.axes.row(2).dot(axes.col(i));
    if (std::abs(towards) < edge_on)
    {
      continue;
    }
    const Vector3<double> middle = state.position + (towards > 0 ? 1 : -1) * halves.col(i);
    const Vector3<double> u = halves.col((i + 1) % 3);
    const Vector3<double> v = halves.col((i + 2) % 3);
    for (const auto& [s, t] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    {
      add_point(outline, project(middle + s * u + t * v));
    }
  }
  return outline;
}

/// How a body is seen; a plane is not, for it is background.
inline Outline
body_outline(const SceneBody& body, const BodyState& state, const Projection& project)
{
  constexpr double far_away = 1e5; // [pixels]
  const Eigen::Vector2d center = project(state.position);
  const bool seen = center.allFinite() && center.cwiseAbs().maxCoeff() < far_away &&
                    state.orientation.coeffs().allFinite();
  Outline outline;
  if (const auto* const box = std::get_if<BoxShape>(&body.shape); box && seen)
  {
    outline = box_outline(box->half_extents, state, project);
  }
  if (const auto* const sphere = std::get_if<SphereShape>(&body.shape); sphere && seen)
  {
    const Vector3<double> spoke = state.orientation * Vector3<double>(sphere->radius, 0, 0);
    add_point(outline, center);
    add_point(outline, project(state.position + spoke));
  }
  return outline;
}

/// Tenths as a number: 123 is `12.3`.
inline std::string tenths_text(long value)
{
  const long size = std::abs(value);
  const std::string fraction = size % 10 == 0 ? "" : "." + std::to_string(size % 10);
  return (value < 0 ? "-" : "") + std::to_string(size / 10) + fraction;
}

/// The outline as the data of an SVG path; `radius` [tenths of a pixel] is a ball's, else zero.
inline std::string outline_data(const Outline& outline, long radius)
{
  const auto pair = [](long x, long y) { return tenths_text(x) + "," + tenths_text(y); };
  std::string data;
  for (std::size_t i = 0; radius == 0 && i < outline.size(); i += 2)
  {
    const bool starts = i % 8 == 0;
    data += starts ? "M" + pair(outline[i], outline[i + 1]) + "l"
                   : (i % 8 == 2 ? "" : ",") +
                         pair(outline[i] - outline[i - 2], outline[i + 1] - outline[i - 1]);
    data += i % 8 == 6 ? "z" : "";
  }
  if (radius != 0 && !outline.empty())
  {
    const std::string arc = "a" + pair(radius, radius) + " 0 1 0 ";
    data = "M" + pair(outline[0] - radius, outline[1]) + arc + pair(2 * radius, 0) + arc +
           pair(-2 * radius, 0) + "M" + pair(outline[0], outline[1]) + "L" +
           pair(outline[2], outline[3]);
  }
  return data.empty() ? "M-9,-9" : data;
}

} // namespace cookbook
