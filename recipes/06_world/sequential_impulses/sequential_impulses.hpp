#pragma once

/// \file
/// \brief Many contacts by impulses: one point after the other, pass by pass, frame by frame.

#include "05_resolution/position_correction/position_correction.hpp"
#include "06_world/islands/island_constraints.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/position_impulse.hpp"
#include "06_world/islands/run_substeps.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cookbook
{

// [sequential_settings]
/// How sequential impulses are run.
struct SequentialSettings
{
  int substeps = 1;            ///< in a frame, one or more
  int iterations = 8;          ///< passes over the velocities in a frame
  bool warm_starting = true;   ///< whether a frame begins with the impulses of the one before
  double correction = 0.2;     ///< [1], fraction of an overlap that a frame pushes out
  double slop = 0.005;         ///< [m], of overlap that stays
  double correction_speed = 3; ///< [m/s], no overlap is pushed out faster
  int position_iterations = 0; ///< passes over the positions, which then push out instead
};
// [sequential_settings]

// [target_speed]
/// The speed [m/s] at which the surfaces are to part at a point, at least.
///
/// Below zero for a gap, which may close in the step [s]; above zero for an overlap, R11.
inline double
target_speed(const IslandPoint& point, double step, const SequentialSettings& settings)
{
  const double separation = point.separation;
  if (separation > 0 || settings.position_iterations > 0)
  {
    return std::min(0.0, -separation / step);
  }
  return bias_velocity(
      -separation, settings.slop, settings.correction / step, settings.correction_speed);
}
// [target_speed]

// [velocity_pass]
/// A contact point and what it is to come to.
struct SequentialPoint
{
  IslandPoint point;
  double target; ///< [m/s], the least separating velocity
};

/// Corrects every point once: its sum of impulses, never below zero, then its friction; R7.
inline void velocity_pass(std::vector<SequentialPoint>& points)
{
  for (SequentialPoint& one : points)
  {
    IslandPoint& point = one.point;
    add_impulse(point, point.normal_mass * (one.target - separating_velocity(point)));
    add_friction(point);
  }
}

/// How far [m/s] the impulses are from an answer: the largest change of speed that R7 would still
/// make at a point; R10.
inline double complementarity_residual(const std::vector<SequentialPoint>& points)
{
  double most = 0;
  for (const auto& [point, target] : points)
  {
    const double pressed = point.impulse / point.normal_mass;
    most = std::max(most, std::abs(std::min(pressed, separating_velocity(point) - target)));
  }
  return most;
}
// [velocity_pass]

// [position_pass]
/// Takes a fraction of every overlap beyond the slop away by moving the bodies, not their
/// velocities; R12.
inline void position_pass(std::vector<SequentialPoint>& points, const SequentialSettings& settings)
{
  for (SequentialPoint& one : points)
  {
    const Vector3<double>& normal = one.point.normal;
    const double separation =
        position_correction(-separation_of(one.point), settings.slop, settings.correction);
    if (separation > 0)
    {
      apply_position_impulse(
          one.point, separation / current_inverse_mass(one.point, normal) * normal);
    }
  }
}
// [position_pass]

// [sequential_impulses]
/// The points of an island, pushed once more as in the step [s] before, or not.
inline std::vector<SequentialPoint> sequential_points(
    IslandView world, const Island& island, double step, const SequentialSettings& settings)
{
  std::vector<SequentialPoint> points;
  for (IslandPoint& point : points_of(world, island))
  {
    if (settings.warm_starting)
    {
      warm_start(point);
    }
    else
    {
      point.impulse = 0;
      point.friction.setZero();
    }
    points.push_back({point, target_speed(point, step, settings)});
  }
  return points;
}

/// Sequential impulses of one island, for run_substeps(); R7.
///
/// Without iterations nothing holds the bodies but the impulses of the step before.
class SequentialImpulses
{
public:
  static constexpr double rounding = velocity_rounding; ///< [1]

  SequentialImpulses(IslandView world, const Island& island, const SequentialSettings& settings)
      : world_(world), island_(island), settings_(settings)
  {
  }

  int prepare(double)
  {
    scale(1.0 / settings_.substeps);
    prepare_constraints(world_, island_, settings_.substeps);
    return settings_.substeps;
  }

  void solve(double substep)
  {
    points_ = sequential_points(world_, island_, substep, settings_);
    warm_start_constraints(world_, island_, substep);
    for (int i = 0; i < settings_.iterations; ++i)
    {
      const double correction = settings_.position_iterations > 0 ? 0 : settings_.correction;
      solve_constraints(world_, island_, {correction / substep, 1, 0});
      velocity_pass(points_);
    }
    for (const SequentialPoint& one : points_)
    {
      cookbook::store(std::span<const IslandPoint>(&one.point, 1));
    }
  }

  void correct(double substep)
  {
    for (int i = 0; i < settings_.position_iterations; ++i)
    {
      correct_constraints(world_, island_, substep, false);
      update_joined_axes(world_, island_);
      position_pass(points_, settings_);
    }
  }

  void relax(double) {}

  void store()
  {
    scale(settings_.substeps);
    store_constraints(world_, island_, settings_.substeps);
  }

private:
  /// Turns impulses of a whole step into those of a substep, or back.
  void scale(double by)
  {
    for (const int number : island_.contacts)
    {
      for (WorldPoint& point : world_.contacts[index_of(number)].points)
      {
        point.impulse = point.warm_start_impulse *= by;
        point.friction *= by;
      }
    }
  }

  IslandView world_;
  const Island& island_;
  const SequentialSettings& settings_;
  std::vector<SequentialPoint> points_;
};

/// Moves the bodies of an island on by a step [s].
inline void sequential_impulses(
    IslandView world, const Island& island, double step, const SequentialSettings& settings)
{
  SequentialImpulses solver(world, island, settings);
  run_substeps(world, {&island, 1}, step, solver);
}
// [sequential_impulses]

} // namespace cookbook
