#pragma once

/// \file
/// \brief A box as the shape of a body: its six functions.

#include "02_primitives/casts/casts.hpp"
#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "04_obb_manifolds/gjk_epa/minkowski_difference.hpp"
#include "06_world/shapes/shape.hpp"

namespace cookbook
{

// [box_shape]
/// A box at a place.
inline Obb<double> placed(const Pose& pose, const BoxShape& box)
{
  return {pose.center, pose.axes, box.half_extents};
}

/// The bounds of a box at a place.
inline Eigen::AlignedBox<double, 3> bounds(const BoxShape& box, const Pose& pose)
{
  const Vector3<double> reach = pose.axes.cwiseAbs() * box.half_extents;
  return {pose.center - reach, pose.center + reach};
}

/// The corner of a box farthest along a direction.
inline Vector3<double> support(const BoxShape& box, const Vector3<double>& direction)
{
  return support_corner<double>(direction, box.half_extents);
}

/// The mass and moments of a box of even density.
inline MassProperties<double> mass_properties(const BoxShape& box, double mass)
{
  return solid_box<double>(mass, box.half_extents);
}

/// How far a box reaches: to its nearest face and to its corners.
inline Extent extent(const BoxShape& box)
{
  return {box.half_extents.minCoeff(), box.half_extents.norm()};
}

/// The direction out of a box at a point [m], and how far that is from its surface [m].
inline Direction<double> distance(const BoxShape& box, const Vector3<double>& point)
{
  return signed_distance_box<double>(point, box.half_extents);
}

/// Where a ray meets a box.
inline ShapeHit cast(const Ray<double>& ray, const BoxShape& box)
{
  return cast(ray, placed({Vector3<double>::Zero(), Matrix3<double>::Identity()}, box));
}
// [box_shape]

} // namespace cookbook
