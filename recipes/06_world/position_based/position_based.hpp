#pragma once

/// \file
/// \brief Many contacts by positions: small steps, each corrected until nothing overlaps (XPBD).

#include "05_resolution/restitution/restitution.hpp"
#include "06_world/contacts/integrate_body.hpp"
#include "06_world/islands/island_constraints.hpp"
#include "06_world/islands/run_substeps.hpp"
#include "06_world/position_based/position_point.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
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
inline void solve_velocity(PositionPoint& one, double threshold)
{
  if (one.normal_lambda > 0)
  {
    const double target = one.separating_before > threshold ? one.separating_before : 0;
    const double change = target - separating_velocity(one.point);
    apply_impulse<double>(
        *one.point.a, *one.point.b, one.point.arms,
        one.point.normal_mass * change * one.point.normal);
  }
}
// [small_step]

// [position_based]
/// The points of an island; each sticks where it stuck in the frame before, if it did.
inline std::vector<PositionPoint>
position_points(IslandView world, const Island& island, double substep)
{
  std::vector<PositionPoint> points;
  for (const IslandPoint& point : points_of(world, island))
  {
    const Vector3<double> stored_slip =
        point.surface.in_world(point.friction) * substep / point.sliding.smallest;
    points.push_back({point, stored_slip});
    point.cached->impulse = 0;
  }
  return points;
}

/// Begins a small step at a point.
inline void begin_substep(PositionPoint& one)
{
  one.point.arms = current_arms(one.point);
  stick(one);
  one.separating_before = separating_velocity(one.point);
  one.normal_lambda = 0;
  one.friction_lambda.setZero();
}

/// Ends a small step [s] at a point: adds its impulse to the frame's, and writes down what friction
/// still owes a point that sticks, as the impulse that would take its slip back.
inline void end_substep(PositionPoint& one, double substep, double threshold)
{
  const bool touches = one.normal_lambda > 0 || separation_of(one.point) <= threshold * substep;
  one.point.arms = current_arms(one.point);
  if (touches)
  {
    compute_masses(one.point);
  }
  solve_velocity(one, threshold);
  one.point.cached->impulse += one.normal_lambda / substep;
  one.stored_slip = touches ? slip(one) : Vector3<double>(0, 0, 0);
  one.point.cached->friction = one.stored_slip * one.point.sliding.smallest / substep;
}

/// Corrected positions of one island, for run_substeps(); R15, R16. Kinematic bodies go along, and
/// back in the end, for they may touch other islands.
///
/// Each small step lets the bodies fall, takes overlaps and slips back by moving them, and then
/// asks with which velocities they have come there.
class PositionBased
{
public:
  static constexpr double rounding = velocity_rounding; ///< [1]

  PositionBased(IslandView world, const Island& island, const PositionSettings& settings)
      : world_(world), island_(island), settings_(settings)
  {
  }

  int prepare(double step)
  {
    points_ = position_points(world_, island_, step / settings_.substeps);
    before_.resize(island_.bodies.size());
    std::for_each(points_.begin(), points_.end(), begin_substep);
    driven_.emplace(world_, island_);
    return settings_.substeps;
  }

  /// Remembers from where the bodies fall.
  void solve(double)
  {
    for (std::size_t k = 0; k < before_.size(); ++k)
    {
      before_[k] = state_of(world_.bodies[index_of(island_.bodies[k])]);
    }
  }

  /// Takes overlaps and slips back.
  void correct(double substep)
  {
    driven_->move(substep);
    const double compliance = settings_.compliance / (substep * substep);
    for (int pass = 0; pass < settings_.iterations; ++pass)
    {
      correct_constraints(world_, island_, substep, pass == 0);
      for (PositionPoint& point : points_)
      {
        solve_normal(point, compliance, settings_.correction_speed * substep);
        solve_friction(point);
      }
    }
  }

  /// Gives the bodies that were corrected the velocities that have led them there.
  void relax(double substep)
  {
    for (std::size_t k = 0; k < before_.size(); ++k)
    {
      if (world_.scratch.free[k].pushed)
      {
        derive_velocities(before_[k], world_.bodies[index_of(island_.bodies[k])], substep);
      }
    }
    const double threshold = restitution_threshold(world_.gravity.norm(), substep);
    for (PositionPoint& point : points_)
    {
      end_substep(point, substep, threshold);
    }
    std::for_each(points_.begin(), points_.end(), begin_substep);
  }

  void store() { driven_.reset(); }

private:
  IslandView world_;
  const Island& island_;
  const PositionSettings& settings_;
  std::vector<PositionPoint> points_;
  std::vector<PreviousState> before_; // of each body, before a small step
  std::optional<DrivenAlong> driven_; // in the step
};

/// Moves the bodies of an island on by a step [s].
inline void position_based(
    IslandView world, const Island& island, double step, const PositionSettings& settings)
{
  PositionBased solver(world, island, settings);
  run_substeps(world, {&island, 1}, step, solver);
}
// [position_based]

} // namespace cookbook
