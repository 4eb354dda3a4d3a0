#pragma once

/// \file
/// \brief What is known of contact points, handed on from tile to tile.

#include "06_world/seams/flush_face.hpp"

#include <span>

namespace cookbook
{

// [hand_over]
/// The point of a body that is no longer where it was and was nearest to a place of its surface, in
/// its frame, on a face with this normal; none within a fraction of the distance from its centre.
inline const LostPoint* nearest_lost(
    std::span<const LostPoint> lost, const RestingContact& of, const Vector3<double>& anchor)
{
  double least = flush_tolerance * flush_tolerance * anchor.squaredNorm();
  const LostPoint* nearest = nullptr;
  for (const LostPoint& one : lost)
  {
    const double distance = (one.anchor - anchor).squaredNorm();
    if (one.moving == of.moving && distance <= least &&
        are_parallel(one.normal, of.normal, resting_angle))
    {
      least = distance;
      nearest = &one;
    }
  }
  return nearest;
}

/// Hands what was known of points on to those that began at the same place of a body, on another
/// tile.
inline void hand_over(const SeamView& view)
{
  for (const RestingContact& of : view.seams.contacts)
  {
    for (WorldPoint& point : of.contact->points)
    {
      const LostPoint* const lost =
          is_known(point) ? nullptr
                          : nearest_lost(view.seams.changes.lost, of, moving_anchor(of, point));
      if (lost != nullptr)
      {
        WorldPoint known = lost->point;
        known.anchor_a = point.anchor_a;
        known.anchor_b = point.anchor_b;
        known.feature = point.feature;
        point = known;
      }
    }
  }
}
// [hand_over]

} // namespace cookbook
