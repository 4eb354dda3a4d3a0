#pragma once

/// \file
/// \brief Many contacts by positions: small steps, each corrected until nothing overlaps (XPBD).

#include "05_resolution/restitution/restitution.hpp"
#include "06_world/contacts/moved_body.hpp"
#include "06_world/position_based/position_point.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [position_settings]
/// How positions are corrected.
struct PositionSettings
{
  int substeps = 20;           ///< small steps in a frame, one or more
  int iterations = 1;          ///< passes over the points in a small step
  double compliance = 0;       ///< [m/N], how far a newton presses a contact in; 0: rigid
  double correction_speed = 1; ///< [m/s], no overlap is taken away faster
};
// [position_settings]

// [small_step]
/// Lets a point that was pressed rest, or part as it did before, however fast it was pushed out.
inline void correct_speed(PositionPoint& one, double threshold)
{
  if (one.pressed > 0)
  {
    const double wanted = one.parted > threshold ? one.parted : 0;
    const double change = wanted - separating_velocity(one.point);
    apply_impulse<double>(
        *one.point.a, *one.point.b, one.point.arms,
        one.point.normal_mass * change * one.point.normal);
  }
}
// [small_step]

// [position_based]
/// The points of an island; each sticks where it stuck in the frame before, if it did.
inline std::vector<PositionPoint>
position_points(IslandView world, const Island& island, double small)
{
  std::vector<PositionPoint> points;
  for (const IslandPoint& point : points_of(world, island))
  {
    const Vector3<double> owed =
        point.surface.in_world(point.friction) * small / point.sliding.smallest;
    points.push_back({point, owed});
    point.known->impulse = 0;
  }
  return points;
}

/// Begins a small step at a point.
inline void begin(PositionPoint& one)
{
  one.point.arms = arms_now(one.point);
  hold(one);
  one.parted = separating_velocity(one.point);
  one.pressed = 0;
  one.rubbed.setZero();
}

/// Ends a small step [s] at a point: adds its impulse to the frame's, and writes down what friction
/// still owes a point that sticks, as the impulse that would take its slip back.
inline void end(PositionPoint& one, double small, double threshold)
{
  const bool touches = one.pressed > 0 || gap(one.point) <= threshold * small;
  one.point.arms = arms_now(one.point);
  if (touches)
  {
    compute_masses(one.point);
  }
  correct_speed(one, threshold);
  one.point.known->impulse += one.pressed / small;
  one.owed = touches ? slip(one) : Vector3<double>(0, 0, 0);
  one.point.known->friction = one.owed * one.point.sliding.smallest / small;
}

/// Moves the bodies of an island on by a step [s]; R15, R16.
///
/// Each small step lets the bodies fall, takes overlaps and slips back by moving them, and then
/// asks with which velocities they have come there.
inline void position_based(
    IslandView world, const Island& island, double step, const PositionSettings& settings)
{
  const double small = step / settings.substeps;
  const double compliance = settings.compliance / (small * small);
  const double threshold = restitution_threshold(world.gravity.norm(), small);
  std::vector<PositionPoint> points = position_points(world, island, small);
  std::vector<RigidBody> before(island.bodies.size());
  const auto each_body = [&](const auto& change)
  {
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      change(before[i], island.bodies[i]);
    }
  };
  for (int i = 0; i < settings.substeps; ++i)
  {
    std::for_each(points.begin(), points.end(), begin);
    each_body(
        [&](RigidBody& was, int body)
        {
          was = world.bodies[place_of(body)];
          pull(world, body, small);
          move(world.bodies[place_of(body)], small);
        });
    for (int pass = 0; pass < settings.iterations; ++pass)
    {
      for (PositionPoint& point : points)
      {
        correct_gap(point, compliance, settings.correction_speed * small);
        correct_slip(point);
      }
    }
    each_body([&](const RigidBody& was, int body)
              { velocities_from(was, world.bodies[place_of(body)], small); });
    std::for_each(
        points.begin(), points.end(), [&](PositionPoint& point) { end(point, small, threshold); });
  }
}
// [position_based]

} // namespace cookbook
