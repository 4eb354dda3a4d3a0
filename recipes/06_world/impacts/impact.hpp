#pragma once

/// \file
/// \brief The hit events of a step: which bodies, where, and how fast.

#include "05_resolution/restitution/restitution.hpp"
#include "06_world/impacts/hit_event.hpp"
#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

namespace cookbook
{

// [impact]
/// What closes by less than this fraction of its size in a step does so by rounding: a thousand
/// lengths that are right to 1e-9 of it.
inline constexpr double hit_fraction = 1e-6;

/// Whether two bodies of a size [m] that close at a speed [m/s] do more in a step [s] than
/// rounding.
inline bool is_hit(double speed, double step, double size)
{
  return speed * step > hit_fraction * size;
}

/// Adds the impacts at an island's contacts: each at that point, of those that do not press yet,
/// which closes fastest in a step [s], if that is faster than what comes to rest.
inline void
add_impacts(IslandView world, const Island& island, double step, std::vector<Impact>& impacts)
{
  for (const int number : island.contacts)
  {
    const WorldContact& contact = world.contacts[index_of(number)];
    const RigidBody &a = world.bodies[index_of(contact.a)], &b = world.bodies[index_of(contact.b)];
    const double acceleration = separating_acceleration(world, contact);
    const double threshold_speed = rest_threshold(world.gravity, acceleration, step);
    Impact fastest{contact.a, contact.b, b.motion.center, contact.normal, threshold_speed};
    for (const WorldPoint& point : contact.points)
    {
      if (is_active(point))
      {
        continue;
      }
      const Arms<double> arms = arms_of(a, b, point);
      const double separating = separating_velocity<double>(a, b, contact.normal, arms);
      const double separation = separation_of(a, b, contact.normal, point);
      const double speed = impact_speed<double>(separating, {acceleration, 0, -separation});
      const bool touches = separation + step * (separating + step * acceleration) <= 0;
      if (speed > fastest.speed && touches && is_hit(speed, step, arms.a.norm() + arms.b.norm()))
      {
        const double time = std::max(0.0, separation / speed);
        fastest.point = b.motion.center + arms.b + time * velocity_at_arm<double>(b.motion, arms.b);
        fastest.speed = speed;
      }
    }
    if (fastest.speed > threshold_speed)
    {
      impacts.push_back(fastest);
    }
  }
}

/// Leaves of all impacts of two bodies the fastest, in the order of their pairs.
inline void keep_fastest(std::vector<Impact>& impacts)
{
  const auto key = [](const Impact& one) { return std::tuple(one.a, one.b, -one.speed); };
  std::sort(
      impacts.begin(), impacts.end(),
      [&](const Impact& one, const Impact& other) { return key(one) < key(other); });
  const auto same = [](const Impact& one, const Impact& other)
  { return one.a == other.a && one.b == other.b; };
  impacts.erase(std::unique(impacts.begin(), impacts.end(), same), impacts.end());
}
// [impact]

} // namespace cookbook
