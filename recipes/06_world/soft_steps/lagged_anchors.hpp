#pragma once

/// \file
/// \brief Arms that stay as they are while a body hardly turns, so that soft towers do not bend.

#include "06_world/islands/island_points.hpp"

namespace cookbook
{

// [lagged_anchors]
/// A body that spins faster than this [rad/s] has its arms taken anew.
inline constexpr double max_lagging_spin = 0.06;

/// Takes the arms at which a body is pushed as it is turned now: unless it spins slowly, and has
/// turned by no more than a limit since they were taken. That is so much [rad] for a cube, and as
/// much less for other boxes as their smallest size is less than their largest.
inline void update_lagged_anchors(RigidBody& body, double limit)
{
  const Vector3<double> since = 2 * (body.orientation * body.lagged_orientation.conjugate()).vec();
  // The square of a size is as the sum of all moments less twice that about its own axis.
  const double sum = body.moments.sum();
  const double smallest = sum - 2 * body.moments.maxCoeff();
  const double largest = sum - 2 * body.moments.minCoeff();
  const bool slow = body.motion.angular_velocity.norm() <= max_lagging_spin;
  if (!(slow && since.squaredNorm() * largest <= limit * limit * smallest))
  {
    body.lagged_orientation = body.orientation;
  }
}

/// The same of all bodies of an island.
inline void update_lagged_anchors(IslandView world, const Island& island, double limit)
{
  for (const int i : island.bodies)
  {
    update_lagged_anchors(world.bodies[index_of(i)], limit);
  }
}

/// How a body, its axes as it is turned now, was turned when its arms were taken; a ball's do not
/// turn with it.
inline Matrix3<double> lagged_axes(const RigidBody& body)
{
  const bool now = body.is_sphere || body.lagged_orientation.coeffs() == body.orientation.coeffs();
  return now ? body.axes : body.lagged_orientation.toRotationMatrix();
}
// [lagged_anchors]

} // namespace cookbook
