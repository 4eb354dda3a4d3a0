#pragma once

/// \file
/// \brief A convex shape at a place, asked in the coordinates of the world.

#include "06_world/shapes/box_shape.hpp"
#include "06_world/shapes/convex_shape.hpp"

namespace cookbook
{

// [placed_convex]
/// A convex shape at a place; it refers to the shape.
template <class Shape>
struct Placed
{
  const Shape& shape;
  Pose pose;
};

/// A convex shape at a place.
inline Placed<ConvexShape> placed(const Pose& pose, const ConvexShape& shape)
{
  return {shape, pose};
}

/// The point of a shape farthest along a direction, world, from its centre [m], world.
template <class Shape>
Vector3<double> support_arm(const Placed<Shape>& placed, const Vector3<double>& direction)
{
  const Vector3<double> local = placed.pose.axes.transpose() * direction;
  return placed.pose.axes * support(placed.shape, local);
}

/// The direction out of a shape at a point [m], both world, and how far that is from its surface.
template <class Shape>
Direction<double> distance(const Placed<Shape>& placed, const Vector3<double>& point)
{
  const Vector3<double> local = placed.pose.axes.transpose() * (point - placed.pose.center);
  const Direction<double> out = distance(placed.shape, local);
  return {placed.pose.axes * out.unit, out.length};
}

/// Where a ray, world, first meets a shape.
template <class Shape>
ShapeHit cast(const Ray<double>& ray, const Placed<Shape>& placed)
{
  const auto& [center, axes] = placed.pose;
  const Ray<double> local{
      axes.transpose() * (ray.origin - center), axes.transpose() * ray.direction};
  const ShapeHit hit = cast(local, placed.shape);
  return hit ? ShapeHit({hit->t, center + axes * hit->point, axes * hit->normal}) : std::nullopt;
}
// [placed_convex]

} // namespace cookbook
