#pragma once

/// \file
/// \brief Bounces of the bodies of an island, all at once, before gravity and contacts have their
/// turn.

#include "05_resolution/island_points.hpp"
#include "05_resolution/restitution.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [impact_target]
/// The speed [m/s] at which the surfaces are to part at a point, or less than zero if nothing
/// bounces there: they part already, or are too slow, or will not touch in this step [s].
inline double impact_target(const IslandPoint& point, const Vector3<double>& gravity, double step)
{
  const double speed = parting_speed(point), apart = gap(point);
  if (speed >= 0 || apart > -speed * step)
  {
    return -1;
  }
  const auto falls = [&](const RigidBody& body) { return is_fixed(body) ? 0.0 : 1.0; };
  const double fall = gravity.dot(point.contact->normal());
  const double acceleration = fall * (falls(*point.b) - falls(*point.a));
  const double threshold = bounce_threshold(gravity.norm(), step);
  const double target = bounced_speed<double>(
      speed, {acceleration, 0, -apart}, point.contact->restitution, threshold);
  return target > 0 ? target : -1;
}
// [impact_target]

// [impacts]
/// A point that bounces, or may be pushed by one that does.
struct ImpactPoint
{
  IslandPoint point;
  WorldPoint sum; ///< what this impact alone has given
  double target;  ///< [m/s]
};

/// Lets the bodies of an island bounce; nothing if none is about to.
///
/// Points that bounce are brought to their targets, points that touch beside them are kept from
/// closing, one after the other until all are right to a billionth, or after 200 rounds.
inline void impacts(IslandView world, const Island& island, double step)
{
  const auto bouncy = [&](int i)
  { return world.contacts[static_cast<std::size_t>(i)].restitution > 0; };
  if (std::none_of(island.contacts.begin(), island.contacts.end(), bouncy))
  {
    return;
  }
  std::vector<ImpactPoint> all;
  double fastest = 0;
  for (const IslandPoint& point : points_of(world, island))
  {
    const double target = impact_target(point, world.gravity, step);
    if (target >= 0 || gap(point) <= 0)
    {
      all.push_back({point, *point.sum, std::max(target, 0.0)});
      all.back().sum.impulse = 0;
      all.back().sum.friction.setZero();
    }
    fastest = std::max(fastest, target);
  }
  double missing = fastest;
  for (int round = 0; round < 200 && missing > 1e-9 * fastest; ++round)
  {
    missing = 0;
    for (ImpactPoint& one : all)
    {
      one.point.sum = &one.sum;
      const double before = one.sum.impulse;
      add_impulse(one.point, one.point.normal_mass * (one.target - parting_speed(one.point)));
      add_friction(one.point);
      missing = std::max(missing, std::abs(one.sum.impulse - before) / one.point.normal_mass);
    }
  }
}
// [impacts]

} // namespace cookbook
