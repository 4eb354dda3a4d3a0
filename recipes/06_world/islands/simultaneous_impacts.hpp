#pragma once

/// \file
/// \brief Bounces of the bodies of an island, all at once, before gravity, forces and contacts have
/// their turn.

#include "05_resolution/restitution/restitution.hpp"
#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <span>
#include <vector>

namespace cookbook
{

// [impact_target]
/// The speed [m/s] at which the surfaces are to part at a point, or less than zero if nothing
/// bounces there: they part already, or are too slow, or will not touch in this step [s].
inline double impact_target(const IslandPoint& point, IslandView world, double step)
{
  const double speed = separating_velocity(point), apart = point.separation;
  if (speed >= 0 || apart > -speed * step)
  {
    return -1;
  }
  const double acceleration = parting_pull(world, *point.contact);
  const double threshold = rest_threshold(world.gravity, acceleration, step);
  const double target = rebound_speed<double>(
      speed, {acceleration, 0, -apart}, point.contact->restitution, threshold);
  return target > 0 ? target : -1;
}
// [impact_target]

// [impact_points]
/// A point that bounces, or may be pushed by one that does; its impulses are what this impact alone
/// has given.
struct ImpactPoint
{
  IslandPoint point;
  double target; ///< [m/s]
};

/// The speed [m/s] at a point that is not told from none: the rounding of those of its bodies.
inline double lost_speed(const IslandPoint& point)
{
  const auto fastest = [](const Motion<double>& motion, const Vector3<double>& arm)
  { return fastest_point(motion.velocity, motion.angular_velocity, arm.norm()); };
  return 4 * std::numeric_limits<double>::epsilon() *
         (fastest(point.a->motion, point.arms.a) + fastest(point.b->motion, point.arms.b));
}

/// How accurate a bounce is, as a share of the fastest speed.
inline constexpr double exact_bounce = 1e-13;

/// By how much more than it misses a point is pushed where a bounce is only asked for roughly: the
/// others take a part of that back. This gets there sooner, but with much friction not to the end.
inline constexpr double over_relaxation = 1.2;

/// Brings points to a share of their targets, and keeps the others from closing, one after the
/// other until a round changes nothing by more than the accuracy, a share of the fastest speed, or
/// by more than is lost to rounding, or 200 times. Two points that stick may strain against each
/// other and move nothing: so it also ends where a round changes less than 1e-5 of the fastest
/// speed, and no less than 0.999 of what the round before did.
inline void
reach_targets(std::vector<ImpactPoint>& points, double share, double accuracy = exact_bounce)
{
  double fastest = 0, lost = 0;
  for (ImpactPoint& one : points)
  {
    one.point.impulse = 0;
    one.point.friction.setZero();
    fastest = std::max({fastest, one.target, -separating_velocity(one.point)});
    lost = std::max(lost, lost_speed(one.point));
  }
  const double enough = std::max(accuracy * fastest, lost);
  const double relaxed = accuracy > exact_bounce ? over_relaxation : 1;
  double missing = fastest, before = 2 * fastest;
  const auto strains = [&] { return missing <= 1e-5 * fastest && missing > 0.999 * before; };
  for (int round = 0; round < 200 && missing > enough && !strains(); ++round)
  {
    before = missing;
    missing = 0;
    for (ImpactPoint& one : points)
    {
      const double given = one.point.impulse;
      const double target = share * one.target;
      add_impulse(
          one.point, relaxed * one.point.normal_mass * (target - separating_velocity(one.point)));
      if (one.point.impulse > 0 || given > 0)
      {
        add_friction(one.point);
      }
      missing = std::max(missing, std::abs(one.point.impulse - given) / one.point.normal_mass);
    }
  }
}

/// Lets points bounce, with as much of their restitution as leaves these bodies no more energy than
/// they had: with friction the whole of it may give them some. False, and nothing changes, where
/// even none does.
inline bool bounce(
    std::vector<ImpactPoint>& points, std::span<RigidBody* const> bodies,
    double accuracy = exact_bounce)
{
  std::vector<Motion<double>> before;
  before.reserve(bodies.size());
  for (const RigidBody* const body : bodies)
  {
    before.push_back(body->motion);
  }
  const auto energy = [&]
  {
    double sum = 0;
    for (const RigidBody* const body : bodies)
    {
      sum += kinetic_energy(*body);
    }
    return sum;
  };
  const double energy_before = energy();
  for (const double share : {1.0, 0.8, 0.6, 0.4, 0.2, 0.0})
  {
    reach_targets(points, share, accuracy);
    if (energy() <= energy_before * (1 + 1e-9))
    {
      return true;
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      bodies[i]->motion = before[i];
    }
  }
  return false;
}
// [impact_points]

// [impacts]
/// How often an island bounces in a step, and at how many points after the first time.
inline constexpr std::size_t most_impacts = 64;

/// Lets the bodies of an island bounce, then those that were pushed; says whether any was about to.
inline bool simultaneous_impacts(IslandView world, const Island& island, double step)
{
  const auto bouncy = [&](int i) { return world.contacts[place_of(i)].restitution > 0; };
  if (std::none_of(island.contacts.begin(), island.contacts.end(), bouncy))
  {
    return false;
  }
  const std::span<const IslandPoint> all = points_of(world, island);
  std::vector<ImpactPoint> points;
  std::set<const RigidBody*> pushed; // what is fixed is not among them
  const auto find_points = [&](bool first)
  {
    points.clear();
    bool any = false;
    for (const IslandPoint& point : all)
    {
      const bool asked = first || pushed.count(point.a) > 0 || pushed.count(point.b) > 0;
      const double target = asked ? impact_target(point, world, step) : -1;
      any = any || target > 0;
      if (asked && (target >= 0 || point.separation <= 0))
      {
        points.push_back({point, std::max(target, 0.0)});
      }
    }
    return any;
  };
  if (!find_points(true))
  {
    return false;
  }
  std::vector<RigidBody*> bodies;
  for (const int i : island.bodies)
  {
    bodies.push_back(&world.bodies[place_of(i)]);
  }
  bool goes_on = true;
  for (std::size_t round = 1; goes_on && bounce(points, bodies) && round < most_impacts; ++round)
  {
    pushed.clear();
    for (const ImpactPoint& one : points)
    {
      if (one.point.impulse > 0)
      {
        pushed.insert({one.point.a, one.point.b});
      }
    }
    std::erase_if(pushed, [](const RigidBody* body) { return is_fixed(*body); });
    goes_on = find_points(false) && points.size() <= most_impacts;
  }
  return true;
}
// [impacts]

} // namespace cookbook
