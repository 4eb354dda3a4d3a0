#pragma once

/// \file
/// \brief The point of a box closest to a given point, and the signed distance between them.

#include "02_primitives/plain_points/plain_points.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>

namespace cookbook
{

// [box_coordinates]
/// Coordinates [m] of a point along the box's axes, from its centre.
///
/// Computed in the wider type: near a face the distance to it is a small difference of large
/// numbers.
template <class Real>
Vector3<Wide<Real>> box_coordinates(const Obb<Real>& box, const Vector3<Real>& point)
{
  return widen(box.axes).transpose() * (widen(point) - widen(box.center));
}
// [box_coordinates]

// [closest_point_box]
/// The point of the box closest to `point` [m], world; a point inside is its own answer; P4.
template <class Real>
Vector3<Real> closest_point(const Obb<Real>& box, const Vector3<Real>& point)
{
  const Vector3<Wide<Real>> local = box_coordinates(box, point);
  const Vector3<Wide<Real>> closest = clamp_to_box<Wide<Real>>(local, widen(box.half_extents));
  if (closest == local)
  {
    return point;
  }
  return (widen(box.center) + widen(box.axes) * closest).template cast<Real>();
}
// [closest_point_box]

// [contains]
/// Whether the box holds the point; its surface belongs to it; P21.
template <class Real>
bool contains(const Obb<Real>& box, const Vector3<Real>& point)
{
  return (box_coordinates(box, point).array().abs() <= widen(box.half_extents).array()).all();
}
// [contains]

// [nearest_face]
/// The displacement out of a box through its nearest face, from a point inside; P5.
///
/// The length is minus the distance to the face. Equal distances: the first of x, y, z; a point
/// in the middle between two faces leaves by the positive one.
template <class Real>
Direction<Real> nearest_face(const Vector3<Real>& local, const Vector3<Real>& half_extents)
{
  const Vector3<Real> inset = half_extents - local.cwiseAbs();
  int axis = 0;
  const Real distance = inset.minCoeff(&axis);
  const Real sign = local[axis] < Real(0) ? Real(-1) : Real(1);
  return {sign * Vector3<Real>::Unit(axis), -distance};
}
// [nearest_face]

// [signed_distance_box]
/// Direction out of the box and signed distance [m] from its surface, in the box's coordinates.
///
/// Outside, towards the point from the point of the box closest to it. Inside and on the surface,
/// the normal of the nearest face, with a distance of zero or less.
template <class Real>
Direction<Real> signed_distance_box(const Vector3<Real>& local, const Vector3<Real>& half_extents)
{
  const Vector3<Real> outside = local - clamp_to_box(local, half_extents);
  return outside.isZero(0) ? nearest_face(local, half_extents) : normalize(outside);
}
// [signed_distance_box]

} // namespace cookbook
