#pragma once

/// \file
/// \brief The residual of an island at given velocities, and how small is small enough.

#include "06_world/direct_solver/direct_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [contact_states]
/// Updates the points of a contact at the present velocities.
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

/// Adds the impulses of a contact, so many times, to the residuals of its two bodies.
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
/// Updates all points and rows at the present velocities, and finds the residual of each body: the
/// impulses on it less its change of momentum.
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

/// How far [N s] friction at a contact may be off its cone: a fraction of the largest impulse
/// [N s], but no more than hardly moves the two bodies, or as much as the residual may be [N s].
inline double friction_tolerance_at(
    const DirectContact& contact, double largest, double residual, const DirectSettings& settings)
{
  const double slight = settings.friction_speed * contact.mass;
  return std::max(residual, std::min(settings.friction_tolerance * largest, slight));
}

/// The squared radius of gyration [m²] about all three axes together: it makes rotations lengths.
inline double squared_radius(const DirectBody& body)
{
  return body.inertia.trace() / body.mass;
}

/// An impulse this many times the momentum that bodies bring into a step, kinematic ones and
/// external accelerations counted, is no load: bodies are jammed between others that do not give
/// way, and the island is over-constrained.
inline constexpr double over_constraint_ratio = 4;
/// Of a body so many times as heavy as the lightest, a machine, only external accelerations count:
/// a game may renew its velocity in every step.
inline constexpr double machine_ratio = 100;

/// Whether an island is over-constrained, by its largest impulse [N s] and its friction.
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

/// The largest speed [m/s] at which an overlap opens at an active point.
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

/// Whether any overlap is to open faster than slow_opening.
inline bool any_opens(const DirectSystem& system)
{
  const auto opens = [](const DirectPoint& point) { return -point.bias > slow_opening; };
  return std::any_of(system.points.begin(), system.points.end(), opens);
}

/// The norm of the residual [N s]; rotations count by the radius of gyration.
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

/// The residual [N s] that rounding of the velocities alone leaves, at the stiffest contact.
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
