#pragma once

/// \file
/// \brief Many contacts by small steps: each contact a stiff damped spring, corrected in turn.

#include "05_resolution/contact_constraint/soft_contact.hpp"
#include "06_world/islands/island_constraints.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/run_substeps.hpp"
#include "06_world/islands/torsional_friction.hpp"
#include "06_world/soft_steps/lagged_anchors.hpp"
#include "06_world/soft_steps/soft_settings.hpp"
#include "06_world/soft_steps/stick_drift.hpp"
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

/// The spring of joints in small steps [s], as stiff as a step can be: critically damped, a quarter
/// of the substeps' rate.
inline Softness<double> joint_spring(double substep)
{
  return softness(0.25 / substep, 1.0, substep);
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

/// Soft steps of one island, for run_substeps(); R13, R16.
class SoftSteps
{
public:
  static constexpr double rounding = velocity_rounding; ///< [1]

  SoftSteps(IslandView world, const Island& island, const SoftSettings& settings)
      : world_(world), island_(island), settings_(settings)
  {
  }

  /// Takes the contacts of the island; so many substeps a step [s] has.
  int prepare(double step)
  {
    update_lagged_anchors(world_, island_, settings_.anchor_lag);
    points_ = points_of(world_, island_, lagged_axes);
    correction_speed_ = island_correction_speed(world_, island_, step, settings_);
    scale_impulses(points_, 1.0 / settings_.substeps);
    for (IslandPoint& point : points_)
    {
      point.drift = drift_of(point, *point.a, *point.b, step / settings_.substeps);
    }
    elapsed_ = -step / settings_.substeps / 2;
    prepare_constraints(world_, island_, settings_.substeps);
    return settings_.substeps;
  }

  /// Pushes with the springs.
  void solve(double substep)
  {
    const Softness<double> spring = contact_spring(substep, settings_);
    warm_start(world_, island_, substep, points_);
    elapsed_ += substep;
    warm_start_constraints(world_, island_, substep);
    solve_constraints(world_, island_, joint_spring(substep));
    for (IslandPoint& point : points_)
    {
      solve_contact<double>(
          *point.a, *point.b, point, spring, substep, correction_speed_, elapsed_);
    }
  }

  /// Solves once more without the springs, so that the speed with which overlaps were taken away
  /// does not stay.
  void relax(double substep)
  {
    const bool turned = any_turns_too_far(world_, island_, substep);
    for (IslandPoint& point : points_)
    {
      point.separation += substep * separating_velocity(point);
      if (turned)
      {
        compute_masses(point);
      }
    }
    relax_constraints(world_, island_);
    for (IslandPoint& point : points_)
    {
      solve_contact<double>(
          *point.a, *point.b, point, rigid<double>(), substep, correction_speed_, elapsed_);
      point.total_impulse += point.impulse;
    }
  }

  /// Writes down the impulses of the step.
  void store()
  {
    cookbook::store(points_, settings_.substeps);
    store_constraints(world_, island_, settings_.substeps);
    apply_torsional_friction(world_, island_, settings_.torsional_radius);
  }

private:
  IslandView world_;
  const Island& island_;
  const SoftSettings& settings_;
  std::span<IslandPoint> points_;
  double correction_speed_ = 0; // [m/s]
  double elapsed_ = 0;          // [s], from the taking of arms to the middle of the small step
};

/// Moves the bodies of an island on by a step [s].
inline void
soft_steps(IslandView world, const Island& island, double step, const SoftSettings& settings)
{
  SoftSteps solver(world, island, settings);
  run_substeps(world, {&island, 1}, step, solver);
}
// [soft_steps]

} // namespace cookbook
