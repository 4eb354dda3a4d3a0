#pragma once

/// \file
/// \brief A point and a plane, a segment, a box: the formulas as they stand, for a room.

#include "02_primitives/plain_points/closest_on_box.hpp"
#include "02_primitives/shapes/shapes.hpp"

#include <algorithm>

namespace cookbook
{

// [signed_distance]
/// How far a point [m], world, is above a plane; negative below it; P1.
template <class Real>
Real signed_distance(const Plane<Real>& plane, const Vector3<Real>& p)
{
  return plane.normal.dot(p) - plane.distance;
}
// [signed_distance]

// [closest_point_segment]
/// How far along a segment, 0 to 1, it comes closest to a point [m], world; P2.
///
/// 0 for a segment without length.
template <class Real>
Real closest_t(const Segment<Real>& segment, const Vector3<Real>& p)
{
  const Vector3<Real> along = segment.end - segment.start;
  const Real squared = along.squaredNorm();
  const Real t = squared > Real(0) ? Real((p - segment.start).dot(along) / squared) : Real(0);
  return std::clamp(t, Real(0), Real(1));
}

/// The point of a segment that is closest to a point, both [m], world; P2. An end is that end
/// itself.
template <class Real>
Vector3<Real> closest_point(const Segment<Real>& segment, const Vector3<Real>& p)
{
  const Real t = closest_t(segment, p);
  return (Real(1) - t) * segment.start + t * segment.end;
}
// [closest_point_segment]

// [signed_distance_of_box]
/// How far a point [m], world, is from the surface of a box; negative inside; P5.
template <class Real>
Real signed_distance(const Obb<Real>& box, const Vector3<Real>& p)
{
  const Vector3<Real> q = box.axes.transpose() * (p - box.center);
  const Vector3<Real> beyond = q.cwiseAbs() - box.half_extents; // each face, seen from inside
  const Real inside = std::min(beyond.maxCoeff(), Real(0));
  return beyond.cwiseMax(Real(0)).norm() + inside;
}
// [signed_distance_of_box]

} // namespace cookbook
