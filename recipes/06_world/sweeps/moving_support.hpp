#pragma once

/// \file
/// \brief How long the gap of two bodies lasts, seen by the support function of one of them.

#include "05_resolution/tunnelling/moving_corners.hpp"
#include "06_world/shapes/gap_between.hpp"

#include <algorithm>
#include <limits>

namespace cookbook
{

// [moving_support]
/// Any convex shape that moves: where a box has corners, it has a support function.
struct MovingSupport
{
  LinearMotion<double> passage;
  const Placed<ConvexShape>& shape;
};
inline MovingSupport
moving_corners(const Placed<ConvexShape>& shape, const LinearMotion<double>& passage)
{
  return {passage, shape};
}

/// The most cuts at the time in which a gap closes: each about squares what is left of the error.
inline constexpr int max_root_cuts = 4;

/// corner_approach() of a body that has any number of corners.
///
/// A point at an arm r is ahead of the frame by n · (c + r), and that changes at the rate
/// n · v + r · w, w = n × Δω, with Δω the spin of the body as the frame sees it. So after a time t
/// the least of all is n · (c + v t) − h(−n − w t): the support function h knows which point comes
/// first, and by when. As a least of straight lines it bends down only: a chord is below it, a
/// tangent above.
inline BoxApproach<double> corner_approach(
    const LinearMotion<double>& frame, const Vector3<double>& direction, double radius_bound,
    const MovingSupport& corners, double allowed, double tolerance)
{
  const LinearMotion<double>& moves = corners.passage;
  const double outer = extent(corners.shape.shape).outer;
  const double growth = max_acceleration(moves, outer, frame, direction);
  const Vector3<double> center = moves.center - frame.center;
  const double center_rate =
      direction.dot(moves.displacement - frame.displacement - frame.rotation.cross(center));
  const Vector3<double> lean = direction.cross(moves.rotation - frame.rotation);
  const auto first_at = [&](double time)
  { return support_arm(corners.shape, -direction - time * lean); };
  const double first = direction.dot(first_at(0));
  const double gap = direction.dot(center) + first - radius_bound + allowed;
  // The point that comes fastest of those which are as near, to twice the tolerance.
  const double turns = outer * lean.norm();
  const double rate = center_rate + lean.dot(first_at(turns > tolerance ? tolerance / turns : 1));
  BoxApproach<double> approach{{direction, gap}, gap <= tolerance && -rate > tolerance, 0};
  const auto left_at = [&](double time, const Vector3<double>& arm)
  {
    return std::max(gap, tolerance) + direction.dot(arm) - first +
           time * (center_rate + lean.dot(arm) - time / 2 * growth);
  };
  double& early = approach.safe_time;
  double late = 1, left = std::max(gap, tolerance);
  for (int i = 0; i < max_root_cuts && left > tolerance / 2; ++i)
  {
    const Vector3<double> arm = first_at(late);
    const double over = left_at(late, arm);
    if (!(over < 0))
    {
      early = i == 0 ? std::numeric_limits<double>::max() : early;
      break;
    }
    early += (late - early) * left / (left - over);
    left = left_at(early, first_at(early));
    late -= over / (center_rate + lean.dot(arm) - late * growth);
  }
  return approach;
}
// [moving_support]

} // namespace cookbook
