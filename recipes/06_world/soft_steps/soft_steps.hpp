#pragma once

/// \file
/// \brief Many contacts by small steps: each contact a stiff damped spring, corrected in turn.

#include "05_resolution/contact_constraint/soft_contact.hpp"
#include "06_world/contacts/integrate_body.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/torsional_friction.hpp"
#include "06_world/soft_steps/lagged_anchors.hpp"
#include "06_world/soft_steps/soft_settings.hpp"
#include "06_world/soft_steps/warm_starting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace cookbook
{

// [soft_steps]
/// The largest angle [rad] by which a box of an island turns in a time [s].
inline double largest_turn(IslandView world, const Island& island, double time)
{
  double fastest = 0; // squared
  for (const int i : island.bodies)
  {
    const RigidBody& body = world.bodies[static_cast<std::size_t>(i)];
    fastest = std::max(fastest, body.is_sphere ? 0 : body.motion.angular_velocity.squaredNorm());
  }
  return time * std::sqrt(fastest);
}

/// A box that turns by more than this [rad] in a frame lies in other overlaps before it is out of
/// those that were found: it is not pushed out of them, which would only give it energy.
inline constexpr double max_correction_turn = 1;

/// The spring of contacts in small steps [s]; R13.
inline Softness<double> contact_spring(double substep, const SoftSettings& settings)
{
  return softness(settings.frequency / substep, settings.damping_ratio, substep);
}

/// How fast [m/s] overlaps of an island are taken away in a step [s].
inline double island_correction_speed(
    IslandView world, const Island& island, double step, const SoftSettings& settings)
{
  return largest_turn(world, island, step) > max_correction_turn ? 0 : settings.correction_speed;
}

/// Turns impulses of a whole frame into those of one of its small steps, or back.
inline void scale_impulses(std::span<IslandPoint> points, double scale)
{
  for (IslandPoint& point : points)
  {
    point.impulse *= scale;
    point.friction *= scale;
  }
}

/// Writes down what points have been given in all small steps of a step, and with what the next
/// step begins: that of the last small step, times their number.
inline void store(std::span<IslandPoint> points, double substeps)
{
  scale_impulses(points, substeps);
  store(points);
  for (const IslandPoint& point : points)
  {
    point.cached->impulse = point.total_impulse;
  }
}

/// Moves the bodies of an island on by a step [s]; R13, R16.
///
/// Each small step pushes with the springs, moves the bodies, and then relaxes: once more without
/// the springs, so that the speed with which overlaps were taken away does not stay.
inline void
soft_steps(IslandView world, const Island& island, double step, const SoftSettings& settings)
{
  update_lagged_anchors(world, island, settings.anchor_lag);
  const std::span<IslandPoint> points = points_of(world, island, lagged_axes);
  const double substep = step / settings.substeps;
  const Softness<double> spring = contact_spring(substep, settings);
  const double correction_speed = island_correction_speed(world, island, step, settings);
  scale_impulses(points, 1.0 / settings.substeps);
  for (int i = 0; i < settings.substeps; ++i)
  {
    for (const int body : island.bodies)
    {
      apply_forces(world, body, substep);
    }
    warm_start(world, island, substep, points);
    for (IslandPoint& point : points)
    {
      solve_contact<double>(*point.a, *point.b, point, spring, substep, correction_speed);
    }
    for (const int body : island.bodies)
    {
      integrate_position(world.bodies[static_cast<std::size_t>(body)], substep);
    }
    const bool turned = any_turns_too_far(world, island, substep);
    for (IslandPoint& point : points)
    {
      point.separation += substep * separating_velocity(point);
      if (turned)
      {
        compute_masses(point);
      }
    }
    for (IslandPoint& point : points)
    {
      solve_contact<double>(*point.a, *point.b, point, rigid<double>(), substep, correction_speed);
      point.total_impulse += point.impulse;
    }
  }
  store(points, settings.substeps);
  apply_torsional_friction(world, island, settings.torsional_radius);
}
// [soft_steps]

} // namespace cookbook
