#pragma once

/// \file
/// \brief Many contacts by positions: small steps, each corrected until nothing overlaps (XPBD).

#include "05_resolution/body_shift.hpp"
#include "05_resolution/restitution.hpp"

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

// [compliant_change]
/// What a correction adds [kg m] to its sum so far, for a constraint that is off by `error` [m];
/// R15.
///
/// `inverse_mass` [1/kg] is the constraint's, `compliance` [1/kg] the material's over the square of
/// the small step: α̃. Zero where nothing can move.
template <class Real>
Real compliant_change(
    const Real& error, const Real& inverse_mass, const Real& compliance, const Real& so_far)
{
  const Real felt = inverse_mass + compliance;
  return felt == Real(0) ? Real(0) : Real((-error - compliance * so_far) / felt);
}
// [compliant_change]

// [position_point]
/// A contact point during a small step.
struct PositionPoint
{
  IslandPoint point;
  Vector3<double> held;                             ///< [m], from A's point to B's, while it sticks
  double parted = 0;                                ///< [m/s], parting speed before the small step
  double pressed = 0;                               ///< [kg m], along the normal, zero or more
  Vector3<double> rubbed = Vector3<double>::Zero(); ///< [kg m], on B, across the normal
};

/// Where B's point is [m] as seen from A's.
inline Vector3<double> between(const IslandPoint& point)
{
  return point.b->position + arm_now(*point.b, point.sum->on_b) - point.a->position -
         arm_now(*point.a, point.sum->on_a);
}

/// Takes an overlap away, or as much of it as the compliance asks; R15.
inline void correct_gap(PositionPoint& one, double compliance, double most)
{
  const Vector3<double>& normal = one.point.contact->normal();
  const double inverse_mass = shift_inverse_mass(one.point, normal);
  const double error = std::max(gap(one.point), -most);
  const double change = compliant_change(error, inverse_mass, compliance, one.pressed);
  const double sum = std::max(0.0, one.pressed + change);
  shift_apart(one.point, (sum - one.pressed) * normal);
  one.pressed = sum;
}

/// How far [m] B's surface has slipped at a point since it began to stick.
inline Vector3<double> slip(const PositionPoint& one)
{
  const Vector3<double>& normal = one.point.contact->normal();
  const Vector3<double> way = between(one.point) - one.held;
  return way - way.dot(normal) * normal;
}

/// Takes a slip back with a friction within the cone; R6.
///
/// Where the cone does not allow that the point slides, and sticks anew where it has come to.
inline void correct_slip(PositionPoint& one)
{
  const Vector3<double> way = slip(one);
  const double length = way.norm();
  if (one.pressed == 0 || length == 0)
  {
    return;
  }
  const double inverse_mass = shift_inverse_mass(one.point, way / length);
  const Vector3<double> wanted = one.rubbed - way / inverse_mass;
  const double most = one.point.contact->friction * one.pressed, size = wanted.norm();
  const Vector3<double> sum = std::min(1.0, most / size) * wanted;
  shift_apart(one.point, sum - one.rubbed);
  one.rubbed = sum;
  if (size > most)
  {
    one.held = between(one.point);
  }
}
// [position_point]

// [small_step]
/// Lets a point that was pressed rest, or part as it did before, however fast it was pushed out.
inline void correct_speed(PositionPoint& one, double threshold)
{
  if (one.pressed > 0)
  {
    const double wanted = one.parted > threshold ? one.parted : 0;
    const double change = wanted - parting_speed(one.point);
    push_apart(
        *one.point.a, *one.point.b, one.point.arm_a, one.point.arm_b,
        one.point.normal_mass * change * one.point.contact->normal());
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
    const Vector3<double> owed = point.sum->friction * small / point.friction_mass;
    points.push_back({point, between(point) - owed});
    point.sum->impulse = 0;
  }
  return points;
}

/// Begins a small step at a point.
inline void begin(PositionPoint& one)
{
  one.parted = parting_speed(one.point);
  one.pressed = 0;
  one.rubbed.setZero();
}

/// Ends a small step [s] at a point: adds its impulse to the frame's, and writes down what friction
/// still owes a point that sticks, as the impulse that would take its slip back.
inline void end(PositionPoint& one, double small, double threshold)
{
  correct_speed(one, threshold);
  one.point.sum->impulse += one.pressed / small;
  const Vector3<double> owed = one.pressed > 0 ? slip(one) : Vector3<double>(0, 0, 0);
  one.point.sum->friction = owed * one.point.friction_mass / small;
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
  const double threshold = bounce_threshold(world.gravity.norm(), small);
  std::vector<PositionPoint> points = position_points(world, island, small);
  std::vector<RigidBody> before(island.bodies.size());
  const auto each_body = [&](const auto& change)
  {
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      change(before[i], world.bodies[static_cast<std::size_t>(island.bodies[i])]);
    }
  };
  for (int i = 0; i < settings.substeps; ++i)
  {
    std::for_each(points.begin(), points.end(), begin);
    each_body(
        [&](RigidBody& was, RigidBody& body)
        {
          was = body;
          body.velocity += small * world.gravity;
          move(body, small);
        });
    for (int pass = 0; pass < settings.iterations; ++pass)
    {
      for (PositionPoint& point : points)
      {
        correct_gap(point, compliance, settings.correction_speed * small);
        correct_slip(point);
      }
    }
    each_body([&](const RigidBody& was, RigidBody& body) { velocities_from(was, body, small); });
    std::for_each(
        points.begin(), points.end(), [&](PositionPoint& point) { end(point, small, threshold); });
  }
}
// [position_based]

} // namespace cookbook
