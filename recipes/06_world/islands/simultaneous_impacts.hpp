#pragma once

/// \file
/// \brief Bounces of the bodies of an island, all at once, before gravity, forces and contacts have
/// their turn.

#include "05_resolution/restitution/restitution.hpp"
#include "06_world/islands/impact_energy.hpp"

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
  const double speed = separating_velocity(point), separation = point.separation;
  if (speed >= 0 || separation > -speed * step)
  {
    return -1;
  }
  const double acceleration = separating_acceleration(world, *point.contact);
  const double threshold = rest_threshold(world.gravity, acceleration, step);
  const double target = rebound_speed<double>(
      speed, {acceleration, 0, -separation}, point.contact->restitution, threshold);
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
inline double speed_rounding(const IslandPoint& point)
{
  const auto fastest = [](const Motion<double>& motion, const Vector3<double>& arm)
  { return fastest_point(motion.velocity, motion.angular_velocity, arm.norm()); };
  return 4 * std::numeric_limits<double>::epsilon() *
         (fastest(point.a->motion, point.arms.a) + fastest(point.b->motion, point.arms.b));
}

/// How accurate a bounce is, as a fraction of the fastest speed.
inline constexpr double impact_tolerance = 1e-13;

/// Passes stagnate where one leaves more than this fraction of what was left, as friction that
/// flips does; below the second fraction of the fastest speed that is good enough.
inline constexpr double stagnating_rate = 0.999, stagnating_fraction = 1e-5;
inline constexpr int max_impact_passes = 200;

/// Over-relaxation (SOR) of impacts solved roughly; with much friction it may not converge.
inline constexpr double over_relaxation = 1.2;

/// Brings points to a fraction of their targets, and keeps the others from closing, by sequential
/// impulses, until what is left is an accuracy, a fraction of the fastest speed, or rounding.
inline void
solve_impact(std::vector<ImpactPoint>& points, double fraction, double accuracy = impact_tolerance)
{
  double fastest = 0, lost = 0;
  for (ImpactPoint& one : points)
  {
    one.point.impulse = 0;
    one.point.friction.setZero();
    fastest = std::max({fastest, one.target, -separating_velocity(one.point)});
    lost = std::max(lost, speed_rounding(one.point));
  }
  const double enough = std::max(accuracy * fastest, lost);
  const double relaxation = accuracy > impact_tolerance ? over_relaxation : 1;
  double residual = fastest, before = 2 * fastest;
  const auto is_stuck = [&]
  { return residual <= stagnating_fraction * fastest && residual > stagnating_rate * before; };
  for (int round = 0; round < max_impact_passes && residual > enough && !is_stuck(); ++round)
  {
    before = residual;
    residual = 0;
    for (ImpactPoint& one : points)
    {
      const double before_impulse = one.point.impulse;
      const double target = fraction * one.target;
      add_impulse(
          one.point,
          relaxation * one.point.normal_mass * (target - separating_velocity(one.point)));
      if (one.point.impulse > 0 || before_impulse > 0)
      {
        add_friction(one.point);
      }
      residual =
          std::max(residual, std::abs(one.point.impulse - before_impulse) / one.point.normal_mass);
    }
  }
}

/// Resolves impacts with as much restitution as adds no energy but the work of kinematic bodies;
/// with friction all of it may add some. False, and nothing changes, where even none does.
inline bool resolve_impacts(
    std::vector<ImpactPoint>& points, std::span<RigidBody* const> bodies,
    double accuracy = impact_tolerance)
{
  std::vector<Motion<double>> before;
  before.reserve(bodies.size());
  for (const RigidBody* const body : bodies)
  {
    before.push_back(body->motion);
  }
  const double energy_before = kinetic_energy_of(bodies);
  for (const double fraction : {1.0, 0.8, 0.6, 0.4, 0.2, 0.0})
  {
    solve_impact(points, fraction, accuracy);
    double work = 0;
    for (const ImpactPoint& one : points)
    {
      work += work_of_driven(one.point);
    }
    if (!has_grown(energy_before, kinetic_energy_of(bodies), work))
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
inline constexpr std::size_t max_impacts = 64;

/// Lets the bodies of an island bounce, then those that were pushed; says whether any was about to.
inline bool simultaneous_impacts(IslandView world, const Island& island, double step)
{
  const auto has_restitution = [&](int i) { return world.contacts[index_of(i)].restitution > 0; };
  if (std::none_of(island.contacts.begin(), island.contacts.end(), has_restitution))
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
    bodies.push_back(&world.bodies[index_of(i)]);
  }
  bool again = true;
  for (std::size_t round = 1; again && resolve_impacts(points, bodies) && round < max_impacts;
       ++round)
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
    again = find_points(false) && points.size() <= max_impacts;
  }
  return true;
}
// [impacts]

} // namespace cookbook
