#pragma once

/// \file
/// \brief The point of a box that is closest to a point: the formula as it stands, for a room.

#include "02_primitives/shapes/shapes.hpp"

namespace cookbook
{

// [closest_on_box]
/// The point of the box [−h, h] closest to `point`, both in the box's coordinates; P3.
template <class Real>
Vector3<Real> clamp_to_box(const Vector3<Real>& point, const Vector3<Real>& half_extents)
{
  return point.cwiseMax(-half_extents).cwiseMin(half_extents);
}

/// The point of a box that is closest to a point, both [m], world; P4.
template <class Real>
Vector3<Real> closest_on_box(const Obb<Real>& box, const Vector3<Real>& p)
{
  const Vector3<Real> q = box.axes.transpose() * (p - box.center);
  return box.center + box.axes * clamp_to_box<Real>(q, box.half_extents);
}
// [closest_on_box]

} // namespace cookbook
