#pragma once

/// \file
/// \brief When two bodies touch on their ways, and which of them goes on by itself.

#include "06_world/sweeps/ccd_pairs.hpp"
#include "06_world/sweeps/predicted_contacts.hpp"
#include "06_world/sweeps/time_of_impact.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace cookbook
{

// [toi_event]
/// Two bodies that touch on their way: the first goes on by itself.
struct ToiEvent
{
  double time;                  ///< [s], of the step
  int first, other;             ///< numbers of bodies
  Vector3<double> normal;       ///< [1], unit, world, from the first to the other
  std::pair<int, int> versions; ///< of the two courses, which may have changed since

  /// Whether it comes later: the earliest is on top of a queue.
  bool operator<(const ToiEvent& next) const
  {
    return std::tie(next.time, next.first, next.other) < std::tie(time, first, other);
  }
};
// [toi_event]

// [moving_first]
/// Whether a body that is hit goes its own way: a ball, a swept box, and what falls. All others lie
/// among others: they are pushed in this step, and move in the next.
inline bool goes_on(const StepTrajectories& step, int i)
{
  const bool alone = is_sphere(step.scene, i) || step.falls[index_of(i)] || is_swept_box(step, i);
  return alone && !is_fixed(*step.trajectories[index_of(i)].of);
}

/// Two bodies that touch, first the one that goes on by itself: a swept box before a ball, that
/// before all others; of two balls one that falls.
inline std::pair<int, int> moving_first(const StepTrajectories& step, int i, int j)
{
  const auto rank = [&](int one)
  {
    const bool sphere = is_sphere(step.scene, one);
    return is_swept_box(step, one) ? 3 : sphere && step.falls[index_of(one)] ? 2 : sphere ? 1 : 0;
  };
  return rank(j) > rank(i) ? std::pair(j, i) : std::pair(i, j);
}

/// Has a box that can move be swept from now on.
inline void start_sweeping(StepTrajectories& step, int box)
{
  if (!is_sphere(step.scene, box) && !is_fixed(*step.trajectories[index_of(box)].of))
  {
    step.needs_sweep[index_of(box)] = true;
  }
}

/// Has a box that a solver has left too deep take along the box that it pressed on: where the one
/// went, it went because of the other.
inline void sweep_partner(StepTrajectories& step, int first, int other)
{
  const bool deep_box = step.needs_sweep[index_of(first)] && !is_sphere(step.scene, first);
  if (deep_box && pressed(step, std::minmax(first, other)))
  {
    start_sweeping(step, other);
  }
}
// [moving_first]

// [next_toi]
/// How deep [m] bodies may lie in each other that rest on each other in the middle of a step.
inline double resting_depth(const Scene& scene, int i, int j)
{
  return allowed_penetration(scene, {i, j}) / 2;
}

/// When a body first touches another from a time [s] to the end of the step, as a fraction of it.
///
/// What presses on each other has been kept apart by a solver, more or less, and touches only where
/// it is deeper than that leaves it: a ball, where it is by `resting_depth` deeper than as the step
/// began. `depth` [m] is how deep two boxes may be that pass. So does what passes over a body that
/// continues a surface which it touches, in which it was `surface_depth` [m] deep.
inline std::optional<SweptHit<double>> next_toi(
    const StepTrajectories& step, int first, int other, double time, double depth,
    std::optional<double> surface_depth = std::nullopt)
{
  const Scene& scene = step.scene;
  const std::pair<int, int> pair = std::minmax(first, other);
  const bool is_touching = surface_depth || pressed(step, pair);
  double allowed = is_touching ? allowed_penetration(scene, pair) : 0;
  if (is_touching && is_sphere(scene, first))
  {
    const auto was = [&](int i)
    { return with_state(*step.trajectories[index_of(i)].of, start_state(step, i)); };
    const double at_first = depth_between(scene, {first, other}, was(first), was(other));
    allowed = std::max(surface_depth.value_or(0), at_first) + resting_depth(scene, first, other);
  }
  const TimeOfImpact time_of_impact{
      step.trajectories[index_of(first)], step.trajectories[index_of(other)], time, scene.step,
      is_sphere(scene, first) ? allowed : std::max(allowed, depth)};
  return std::visit(
      time_of_impact, scene.bodies[index_of(first)].shape, scene.bodies[index_of(other)].shape);
}
// [next_toi]

} // namespace cookbook
