#pragma once

/// \file
/// \brief All that lies below a plane as the shape of a fixed body.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/plain_points/plain_points.hpp"
#include "06_world/shapes/shape.hpp"

#include <limits>

namespace cookbook
{

// [plane_shape]
/// A plane, which is where it is.
inline Plane<double> placed(const Pose&, const PlaneShape& plane)
{
  return {plane.normal, plane.offset};
}

/// Everything.
inline Eigen::AlignedBox<double, 3> bounds(const PlaneShape&, const Pose&)
{
  const Vector3<double> reach = Vector3<double>::Constant(std::numeric_limits<double>::infinity());
  return {-reach, reach};
}

/// None: nothing moves it.
inline MassProperties<double> mass_properties(const PlaneShape&, double)
{
  return {0, Vector3<double>::Zero()};
}

/// It has no centre that it would reach from, and no end.
inline Extent extent(const PlaneShape&)
{
  return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

/// The direction out of the solid, and how far [m] a point is above it.
inline Direction<double> distance(const PlaneShape& plane, const Vector3<double>& point)
{
  return {plane.normal, signed_distance(Plane<double>{plane.normal, plane.offset}, point)};
}

/// Where a ray meets the solid.
inline ShapeHit cast(const Ray<double>& ray, const PlaneShape& plane)
{
  return cast(ray, Plane<double>{plane.normal, plane.offset});
}
// [plane_shape]

} // namespace cookbook
