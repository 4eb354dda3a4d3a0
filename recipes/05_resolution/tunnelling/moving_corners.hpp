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
struct Passage
{
  Vector3<Real> center; ///< [m], world, now
  Vector3<Real> way;    ///< [m], at its present velocity
  Vector3<Real> pull;   ///< [m], by how much that way grows, steadily
  Vector3<Real> turn;   ///< [rad], axis times angle
};

/// The corners of a body that moves: those of a box, or the centre of a ball.
template <class Real>
struct MovingCorners
{
  Passage<Real> passage;
  std::array<Vector3<Real>, 8> arms; ///< [m], world, from the centre to each corner
  std::size_t count;                 ///< how many there are
  Real reach;                        ///< [m], of the longest arm
  Real radius;                       ///< [m], of a ball; 0 otherwise
};

/// The eight corners of a box.
template <class Real>
MovingCorners<Real> moving_corners(const Obb<Real>& box, const Passage<Real>& passage)
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
MovingCorners<Real> moving_corners(const Sphere<Real>& ball, const Passage<Real>& passage)
{
  return {passage, {Vector3<Real>::Zero()}, 1, Real(0), ball.radius};
}
// [moving_corners]

// [corner_outlook]
/// By how much [m] the rates may grow until time 1 at which corners come closer along a direction
/// that a frame carries along: pulls, the turning of the corners, and that of the frame; P23.
template <class Real>
Real most_bend(
    const MovingCorners<Real>& corners, const Passage<Real>& frame, const Vector3<Real>& direction)
{
  const Passage<Real>& moves = corners.passage;
  const Vector3<Real> pull = moves.pull - frame.pull;
  const Real spin = moves.turn.norm(), turn = frame.turn.norm();
  if (!(turn > Real(0)))
  {
    return std::max(Real(0), Real(-pull.dot(direction))) +
           spin * corners.reach * moves.turn.cross(direction).norm();
  }
  const Real way = (moves.way - frame.way).norm() + pull.norm();
  const Real speed = way + spin * corners.reach;
  const Real farthest = (moves.center - frame.center).norm() + way + corners.reach;
  return pull.norm() + spin * spin * corners.reach + Real(2) * turn * speed +
         turn * turn * farthest;
}

/// What a body sees of the corners of another along a direction towards that other, up to which it
/// reaches by so much [m] from its centre; P23 for each corner. The direction turns with the body.
///
/// Corners may come closer by an `allowed` depth [m]. Gaps and approaches of up to `touching` [m]
/// count as none.
template <class Real>
BoxOutlook<Real> corner_outlook(
    const Passage<Real>& frame, const Vector3<Real>& direction, const Real& reach,
    const MovingCorners<Real>& corners, const Real& allowed, const Real& touching)
{
  const Real most = std::numeric_limits<Real>::max();
  const Real bend = most_bend(corners, frame, direction);
  const Passage<Real>& moves = corners.passage;
  BoxOutlook<Real> outlook{{direction, most}, false, most};
  for (std::size_t i = 0; i < corners.count; ++i)
  {
    const Vector3<Real>& arm = corners.arms[i];
    const Vector3<Real> place = moves.center - frame.center + arm;
    const Vector3<Real> rate =
        moves.way - frame.way + moves.turn.cross(arm) - frame.turn.cross(place);
    const Real gap = direction.dot(place) - reach - corners.radius + allowed;
    const Real closing = -direction.dot(rate);
    outlook.ahead.length = std::min(outlook.ahead.length, gap);
    outlook.closes = outlook.closes || (gap <= touching && closing > touching);
    outlook.lasts = std::min(outlook.lasts, lasting_time(std::max(gap, touching), closing, bend));
  }
  return outlook;
}
// [corner_outlook]

} // namespace cookbook
