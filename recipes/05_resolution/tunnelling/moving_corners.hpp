#pragma once

/// \file
/// \brief How long the gap of two bodies lasts, corner by corner: sharper than their largest
/// speeds.

#include "02_primitives/shape_bounds/corner_arm.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "05_resolution/tunnelling/swept_box.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [moving_corners]
/// How a body moves until time 1.
template <class Real>
struct LinearMotion
{
  Vector3<Real> center;       ///< [m], world, now
  Vector3<Real> displacement; ///< [m], at its present velocity
  Vector3<Real> acceleration; ///< [m], by how much that way grows, steadily
  Vector3<Real> rotation;     ///< [rad], axis times angle
};

/// The corners of a body that moves: those of a box, or the centre of a ball.
template <class Real>
struct MovingCorners
{
  LinearMotion<Real> passage;
  std::array<Vector3<Real>, 8> arms; ///< [m], world, from the centre to each corner
  std::size_t count;                 ///< how many there are
  Real radius_bound;                 ///< [m], of the longest arm
  Real radius;                       ///< [m], of a ball; 0 otherwise
};

/// The eight corners of a box.
template <class Real>
MovingCorners<Real> moving_corners(const Obb<Real>& box, const LinearMotion<Real>& passage)
{
  MovingCorners<Real> corners{passage, {}, 8, box.half_extents.norm(), Real(0)};
  for (unsigned i = 0; i < 8; ++i)
  {
    corners.arms[i] = corner_arm(box, i);
  }
  return corners;
}

/// A ball, as one corner that is round.
template <class Real>
MovingCorners<Real> moving_corners(const Sphere<Real>& sphere, const LinearMotion<Real>& passage)
{
  return {passage, {Vector3<Real>::Zero()}, 1, Real(0), sphere.radius};
}
// [moving_corners]

// [corner_approach]
/// By how much [m] the rates may grow until time 1 at which points of a body, all within a radius
/// [m] of its centre, come closer along a direction that a frame carries along: pulls, the turning
/// of the body, and that of the frame; P23.
template <class Real>
Real max_acceleration(
    const LinearMotion<Real>& moves, const Real& radius_bound, const LinearMotion<Real>& frame,
    const Vector3<Real>& direction)
{
  const Vector3<Real> acceleration = moves.acceleration - frame.acceleration;
  const Real spin = moves.rotation.norm(), rotation = frame.rotation.norm();
  if (!(rotation > Real(0)))
  {
    return std::max(Real(0), Real(-acceleration.dot(direction))) +
           spin * radius_bound * moves.rotation.cross(direction).norm();
  }
  const Real displacement = (moves.displacement - frame.displacement).norm() + acceleration.norm();
  const Real speed = displacement + spin * radius_bound;
  const Real farthest = (moves.center - frame.center).norm() + displacement + radius_bound;
  return acceleration.norm() + spin * spin * radius_bound + Real(2) * rotation * speed +
         rotation * rotation * farthest;
}

/// What a body sees of the corners of another along a direction towards that other, up to which it
/// reaches by so much [m] from its centre; P23 for each corner. The direction turns with the body.
///
/// Corners may come closer by an `allowed` depth [m]. Gaps and approaches of up to `tolerance` [m]
/// count as none.
template <class Real>
BoxApproach<Real> corner_approach(
    const LinearMotion<Real>& frame, const Vector3<Real>& direction, const Real& radius_bound,
    const MovingCorners<Real>& corners, const Real& allowed, const Real& tolerance)
{
  const Real most = std::numeric_limits<Real>::max();
  const Real acceleration_bound =
      max_acceleration(corners.passage, corners.radius_bound, frame, direction);
  const LinearMotion<Real>& moves = corners.passage;
  BoxApproach<Real> approach{{direction, most}, false, most};
  for (std::size_t i = 0; i < corners.count; ++i)
  {
    const Vector3<Real>& arm = corners.arms[i];
    const Vector3<Real> place = moves.center - frame.center + arm;
    const Vector3<Real> rate = moves.displacement - frame.displacement + moves.rotation.cross(arm) -
                               frame.rotation.cross(place);
    const Real gap = direction.dot(place) - radius_bound - corners.radius + allowed;
    const Real closing = -direction.dot(rate);
    approach.gap.length = std::min(approach.gap.length, gap);
    approach.closes = approach.closes || (gap <= tolerance && closing > tolerance);
    approach.safe_time = std::min(
        approach.safe_time, safe_time(std::max(gap, tolerance), closing, acceleration_bound));
  }
  return approach;
}
// [corner_approach]

} // namespace cookbook
