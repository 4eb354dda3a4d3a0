#pragma once

/// \file
/// \brief What is missing in an island at given velocities, and how little is little enough.

#include "06_world/direct_solver/direct_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [contact_states]
/// Presses the points of a contact at the velocities as they are.
inline void update_point(DirectSystem& system, const DirectContact& contact)
{
  const Motion<double> a = motion_of(system, contact, contact.a);
  const Motion<double> b = motion_of(system, contact, contact.b);
  for (std::size_t i = contact.first; i < contact.end; ++i)
  {
    DirectPoint& point = system.points[i];
    const Vector3<double> velocity = relative_velocity(a, b, point.arms);
    update_point(point, contact.of->normal, velocity, contact.stiffness);
  }
}

/// Adds what the points of a contact give its two bodies, so many times, to what these are missing.
inline void add_impulses(DirectSystem& system, const DirectContact& contact, double times)
{
  const Vector3<double> normal = contact.of->normal;
  Vector6 on_a = Vector6::Zero(), on_b = Vector6::Zero();
  for (std::size_t i = contact.first; i < contact.end; ++i)
  {
    const DirectPoint& point = system.points[i];
    const Vector3<double> impulse = point.impulse * normal + point.friction;
    on_a.head<3>() -= impulse;
    on_a.tail<3>() -= point.arms.a.cross(impulse);
    on_b.head<3>() += impulse;
    on_b.tail<3>() += point.arms.b.cross(impulse);
  }
  if (contact.a >= 0)
  {
    system.residual[index_of(contact.a)] += times * on_a;
  }
  if (contact.b >= 0)
  {
    system.residual[index_of(contact.b)] += times * on_b;
  }
}
// [contact_states]

// [direct_residual]
/// Presses all points at the velocities as they are, and finds the impulses that are missing, body
/// by body: those of the contacts less the change of momentum.
inline void find_residual(DirectSystem& system)
{
  system.residual.resize(system.bodies.size());
  for (std::size_t i = 0; i < system.bodies.size(); ++i)
  {
    const DirectBody& body = system.bodies[i];
    const Vector6 change = body.free - system.velocities[i];
    system.residual[i] << body.mass * change.head<3>(), body.inertia * change.tail<3>();
  }
  for (std::size_t i = 0; i < system.taut.size(); ++i)
  {
    system.residual[i].tail<3>() -= system.taut[i] * system.velocities[i].tail<3>();
  }
  for (const DirectContact& contact : system.contacts)
  {
    update_point(system, contact);
    add_impulses(system, contact, 1);
  }
  for (DirectRow& row : system.rows)
  {
    update_row(row, system.velocities, system.residual);
  }
}
// [direct_residual]

// [tolerances]
/// The largest impulse [N s] of an island.
inline double largest_impulse(const DirectSystem& system)
{
  double most = 0;
  for (const DirectPoint& point : system.points)
  {
    most = std::max(most, point.impulse);
  }
  for (const DirectRow& row : system.rows)
  {
    most = std::max(most, std::abs(row.impulse));
  }
  return most;
}

/// How far [N s] friction at a contact may be off its cone: by the largest impulse [N s], but by no
/// more than slightly changes the two bodies, unless so much may be missing [N s].
inline double friction_tolerance_at(
    const DirectContact& contact, double largest, double residual, const DirectSettings& settings)
{
  const double slight = settings.friction_speed * contact.mass;
  return std::max(residual, std::min(settings.friction_tolerance * largest, slight));
}

/// A square [m²] of the radius of gyration about all axes together: by it turns count as ways.
inline double squared_radius(const DirectBody& body)
{
  return body.inertia.trace() / body.mass;
}

/// No load is so many times what the bodies of an island bring into a step, each by its motion and
/// by what pulls it, and what kinematic bodies bring. More is the strain of bodies that are jammed
/// between others which give no way.
inline constexpr double over_constraint_ratio = 4;
/// A machine, so many times as heavy as the lightest, brings only what pulls it: a game may renew
/// its motion in every step.
inline constexpr double machine_ratio = 100;

/// Whether the largest impulse [N s] of an island, or its friction, is such a strain.
inline bool is_over_constrained(const DirectSystem& system, double largest)
{
  for (const DirectPoint& point : system.points)
  {
    largest = std::max(largest, point.friction.norm());
  }
  double lightest = std::numeric_limits<double>::infinity(), brought = 0; // [kg], [N s]
  for (const DirectBody& body : system.bodies)
  {
    lightest = std::min(lightest, body.mass);
  }
  for (const DirectBody& body : system.bodies)
  {
    const Vector6& brings = body.mass > machine_ratio * lightest ? body.pulled : body.free;
    const Vector3<double> velocity = brings.head<3>(), spin = brings.tail<3>();
    brought +=
        body.mass * std::sqrt(velocity.squaredNorm() + squared_radius(body) * spin.squaredNorm());
  }
  for (const DirectContact& contact : system.contacts)
  {
    if (contact.a < 0 || contact.b < 0)
    {
      const Arms<double>& arms = system.points[contact.first].arms;
      const Vector3<double>& arm = contact.a < 0 ? arms.a : arms.b;
      const Motion<double>& driven = contact.driven;
      brought += contact.mass * (driven.velocity + driven.angular_velocity.cross(arm)).norm();
    }
  }
  return largest > over_constraint_ratio * brought;
}

/// How fast [m/s] overlaps open, at that point among those that push where it is fastest.
inline double fastest_opening(const DirectSystem& system)
{
  double fastest = 0;
  for (const DirectContact& contact : system.contacts)
  {
    for (std::size_t i = contact.first; i < contact.end; ++i)
    {
      const DirectPoint& point = system.points[i];
      const double opening = -point.bias - point.impulse / contact.stiffness.push;
      fastest = point.active && point.bias < 0 ? std::max(fastest, opening) : fastest;
    }
  }
  return fastest;
}

/// Whether any overlap is to open faster than slowly.
inline bool any_opens(const DirectSystem& system)
{
  const auto opens = [](const DirectPoint& point) { return -point.bias > slow_opening; };
  return std::any_of(system.points.begin(), system.points.end(), opens);
}

/// How much is missing [N s], as a root of a sum of squares; turns count by the radius of gyration.
inline double residual_norm(const DirectSystem& system)
{
  double sum = 0;
  for (std::size_t i = 0; i < system.residual.size(); ++i)
  {
    sum += system.residual[i].head<3>().squaredNorm() +
           system.residual[i].tail<3>().squaredNorm() / squared_radius(system.bodies[i]);
  }
  return std::sqrt(sum);
}

/// What rounding of the velocities alone leaves missing [N s], at the stiffest contact.
inline double rounding_of(const DirectSystem& system)
{
  double fastest = 0, stiffest = 0;
  for (const Vector6& velocity : system.velocities)
  {
    fastest = std::max(fastest, velocity.head<3>().cwiseAbs().maxCoeff());
  }
  for (const DirectContact& contact : system.contacts)
  {
    stiffest = std::max(stiffest, contact.stiffness.push);
  }
  for (const DirectRow& row : system.rows)
  {
    stiffest = std::max(stiffest, row.stiffness);
  }
  return 8 * std::numeric_limits<double>::epsilon() * fastest * stiffest;
}
// [tolerances]

} // namespace cookbook
