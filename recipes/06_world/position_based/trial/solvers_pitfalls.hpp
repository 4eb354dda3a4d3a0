#pragma once

/// \file
/// \brief A frame of many contacts as the code published with the seed book goes through it.

#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <vector>

namespace cookbook
{

// [published_frame]
/// Moves the bodies of an island on by a step [s], after the published order: impulses before
/// gravity, each divided by the number of points, none remembered; then gravity and damping; then
/// overlaps as they were before all that are pushed apart.
inline void published_frame(IslandView world, const Island& island, double step)
{
  const std::span<IslandPoint> all = points_of(world, island);
  std::vector<IslandPoint> points(all.begin(), all.end());
  std::erase_if(points, [](const IslandPoint& point) { return separation_of(point) > 0; });
  std::vector<double> stale;
  for (IslandPoint& point : points)
  {
    stale.push_back(-separation_of(point));
    point.friction.setZero();
  }
  for (int pass = 0; pass < 5; ++pass)
  {
    for (IslandPoint& point : points)
    {
      const auto shared = static_cast<double>(point.contact->points.size());
      point.impulse = 0;
      add_impulse(point, -point.normal_mass * separating_velocity(point) / shared);
      add_friction(point);
    }
  }
  store(points);
  for (const int number : island.bodies)
  {
    RigidBody& body = world.bodies[static_cast<std::size_t>(number)];
    body.motion.velocity = 0.98 * (body.motion.velocity + step * world.gravity);
    body.motion.angular_velocity *= 0.98;
    integrate_position(body, step);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    RigidBody &a = *points[i].a, &b = *points[i].b;
    const double push = 0.45 * std::max(0.0, stale[i] - 0.01) / (a.inverse_mass + b.inverse_mass);
    a.motion.center -= push * a.inverse_mass * points[i].normal;
    b.motion.center += push * b.inverse_mass * points[i].normal;
  }
}
// [published_frame]

} // namespace cookbook
