#pragma once

/// \file
/// \brief Ways to answer for a point and a box that fail somewhere, beside the recommended one.

#include "02_primitives/closest_point_box/closest_point_box.hpp"

namespace cookbook
{

// [clamp_mixed_bounds]
/// Clamps each coordinate to its own bounds, but asks only whether it passes those of x.
///
/// A model of a published fault, in our own words: in a box that is longer along x than along y, a
/// point well above it is taken to be inside.
template <class Real>
Vector3<Real> clamp_mixed_bounds(const Vector3<Real>& point, const Vector3<Real>& half_extents)
{
  Vector3<Real> clamped = point;
  for (int i = 0; i < 3; ++i)
  {
    if (point[i] > half_extents.x())
    {
      clamped[i] = half_extents[i];
    }
    if (point[i] < -half_extents.x())
    {
      clamped[i] = -half_extents[i];
    }
  }
  return clamped;
}

/// Direction and distance to the point that mixed bounds call the closest.
template <class Real>
Direction<Real> distance_mixed_bounds(const Vector3<Real>& local, const Vector3<Real>& half_extents)
{
  return normalize<Real>(local - clamp_mixed_bounds(local, half_extents));
}
// [clamp_mixed_bounds]

// [distance_unguarded]
/// Divides the way from the closest point by its length, also where that is zero.
template <class Real>
Direction<Real> distance_unguarded(const Vector3<Real>& local, const Vector3<Real>& half_extents)
{
  const Vector3<Real> outside = local - clamp_to_box(local, half_extents);
  const Real length = outside.norm();
  return {outside / length, length};
}
// [distance_unguarded]

// [distance_shell]
/// Takes everything within a shell of 0.345 mm for inside, and points inside away from the centre.
///
/// A model of a published fault, in our own words.
template <class Real>
Direction<Real> distance_shell(const Vector3<Real>& local, const Vector3<Real>& half_extents)
{
  const Real shell = Real(1.19e-7); // [m²], whatever the size of the box
  const Vector3<Real> outside = local - clamp_to_box(local, half_extents);
  if (outside.squaredNorm() <= shell)
  {
    return {local / local.norm(), Real(0)};
  }
  return normalize(outside);
}
// [distance_shell]

} // namespace cookbook
