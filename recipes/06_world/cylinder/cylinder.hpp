#pragma once

/// \file
/// \brief A cylinder as the shape of a body, in six functions: how a new shape enters the world.

#include "02_primitives/casts/cast_sphere.hpp"
#include "06_world/shapes/shape_answers.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [cylinder]
/// A solid cylinder about the y axis of its body.
struct Cylinder
{
  double radius;      ///< [m], greater than zero
  double half_height; ///< [m], greater than zero
};

/// The bounds of a cylinder at a place: along each axis of the world, those of its two discs.
inline Eigen::AlignedBox<double, 3> bounds(const Cylinder& cylinder, const Pose& pose)
{
  const auto disc = [&](int i) { return std::hypot(pose.axes(i, 0), pose.axes(i, 2)); };
  const Vector3<double> reach = cylinder.half_height * pose.axes.col(1).cwiseAbs() +
                                cylinder.radius * Vector3<double>(disc(0), disc(1), disc(2));
  return {pose.center - reach, pose.center + reach};
}

/// The point of its two rims farthest along a direction.
inline Vector3<double> support(const Cylinder& cylinder, const Vector3<double>& direction)
{
  const Vector3<double> out =
      normalize<double>({direction.x(), 0, direction.z()}, Vector3<double>::UnitX()).unit;
  const double end = direction.y() < 0 ? -cylinder.half_height : cylinder.half_height;
  return cylinder.radius * out + end * Vector3<double>::UnitY();
}

/// The mass and moments of a cylinder of even density: m r²/2 about its axis, and
/// m (r²/4 + h²/3) across, where h is half its height.
inline MassProperties<double> mass_properties(const Cylinder& cylinder, double mass)
{
  const double along = mass * cylinder.radius * cylinder.radius / 2;
  const double across = along / 2 + mass * cylinder.half_height * cylinder.half_height / 3;
  return {mass, {across, along, across}};
}

/// How far it reaches: to its side or its discs, and to its rims.
inline Extent extent(const Cylinder& cylinder)
{
  return {
      std::min(cylinder.radius, cylinder.half_height),
      std::hypot(cylinder.radius, cylinder.half_height)};
}

/// The direction out of the cylinder at a point, and how far that is from its surface: in the plane
/// through the point and the axis, that of a rectangle.
inline Direction<double> distance(const Cylinder& cylinder, const Vector3<double>& point)
{
  const Direction<double> out =
      normalize<double>({point.x(), 0, point.z()}, Vector3<double>::UnitX());
  const Vector3<double> up = Vector3<double>::UnitY() * (point.y() < 0 ? -1 : 1);
  const double beyond_side = out.length - cylinder.radius;
  const double beyond_end = std::abs(point.y()) - cylinder.half_height;
  if (beyond_side > 0 && beyond_end > 0)
  {
    return normalize<double>(beyond_side * out.unit + beyond_end * up);
  }
  return beyond_side > beyond_end ? Direction<double>{out.unit, beyond_side}
                                  : Direction<double>{up, beyond_end};
}
// [cylinder]

// [cylinder_cast]
/// Where a ray meets the disc at the end of a cylinder that it comes from.
inline ShapeHit cast_at_end(const CastPath<double>& path, const Cylinder& cylinder)
{
  const double side = path.origin.y() < 0 ? -1 : 1;
  const double height = side * path.origin.y() - cylinder.half_height;
  const double approach = -side * path.direction.y();
  if (height < 0 || !(approach > 0))
  {
    return std::nullopt;
  }
  Vector3<double> point = path.origin + height / approach * path.direction;
  point.y() = side * cylinder.half_height;
  const bool on_disc = std::hypot(point.x(), point.z()) <= cylinder.radius;
  return on_disc ? hit_at<double>(path, height / approach, side * Vector3<double>::UnitY(), point)
                 : std::nullopt;
}

/// Where a ray first meets a cylinder: one of its discs, or its round side, which is a capsule's.
inline ShapeHit cast(const Ray<double>& ray, const Cylinder& cylinder)
{
  const CastPath<double> path{ray.origin, ray.direction, false};
  if (distance(cylinder, ray.origin).length <= 0)
  {
    return hit_from_inside(path);
  }
  const Vector3<double> end = cylinder.half_height * Vector3<double>::UnitY();
  const ShapeHit hit = cast_at_end(path, cylinder);
  return hit ? hit : hit_on_side(path, Capsule<double>{{-end, end}, cylinder.radius});
}
// [cylinder_cast]

} // namespace cookbook
