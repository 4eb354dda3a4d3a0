#pragma once

/// \file
/// \brief For how long the gap between two bodies stays open, by the support function of one.

#include "05_resolution/tunnelling/moving_corners.hpp"
#include "06_world/shapes/gap_between.hpp"

#include <algorithm>
#include <limits>

namespace cookbook
{

// [moving_support]
/// A moving convex shape: what corners are to a box, its support function is to it.
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

/// The most iterations for the time at which a gap closes; each about squares the error.
inline constexpr int max_root_cuts = 4;

/// corner_approach() of a shape without corners.
///
/// A point at an arm r is at the distance n · (c + r) from the frame, and that changes at the rate
/// n · v + r · w, w = n × Δω, with Δω the spin of the body as the frame sees it. So after a time t
/// the least distance of all points is n · (c + v t) − h(−n − w t), with the support function h. As
/// a minimum of straight lines it is concave: a chord lies below it, a tangent above, so a chord
/// meets zero too early and a tangent too late.
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
  const Vector3<double> w = direction.cross(moves.rotation - frame.rotation);
  const auto nearest_arm = [&](double time)
  { return support_arm(corners.shape, -direction - time * w); };
  const double nearest = direction.dot(nearest_arm(0));
  const double gap = direction.dot(center) + nearest - radius_bound + allowed;
  // The rate of the fastest point among those that are nearest, to twice the tolerance.
  const double turns = outer * w.norm();
  const double rate = center_rate + w.dot(nearest_arm(turns > tolerance ? tolerance / turns : 1));
  BoxApproach<double> approach{{direction, gap}, gap <= tolerance && -rate > tolerance, 0};
  const auto gap_at = [&](double time, const Vector3<double>& arm)
  {
    return std::max(gap, tolerance) + direction.dot(arm) - nearest +
           time * (center_rate + w.dot(arm) - time / 2 * growth);
  };
  // Narrows the time at which the gap closes, from below by chords, from above by tangents.
  double& early = approach.safe_time;
  double late = 1, gap_early = std::max(gap, tolerance);
  for (int i = 0; i < max_root_cuts && gap_early > tolerance / 2; ++i)
  {
    const Vector3<double> arm = nearest_arm(late);
    const double gap_late = gap_at(late, arm);
    if (!(gap_late < 0)) // it stays open
    {
      early = i == 0 ? std::numeric_limits<double>::max() : early;
      break;
    }
    early += (late - early) * gap_early / (gap_early - gap_late);
    gap_early = gap_at(early, nearest_arm(early));
    late -= gap_late / (center_rate + w.dot(arm) - late * growth);
  }
  return approach;
}
// [moving_support]

} // namespace cookbook
