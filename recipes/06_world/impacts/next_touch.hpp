#pragma once

/// \file
/// \brief When two bodies touch on their ways, and which of them goes on by itself.

#include "06_world/sweeps/box_on_course.hpp"
#include "06_world/sweeps/foreseen.hpp"
#include "06_world/sweeps/pairs_in_danger.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

namespace cookbook
{

// [course_touch]
/// Two bodies that touch on their way: the first goes on by itself.
struct CourseTouch
{
  double time;                  ///< [s], of the step
  int first, other;             ///< numbers of bodies
  Vector3<double> normal;       ///< [1], unit, world, from the first to the other
  std::pair<int, int> versions; ///< of the two courses, which may have changed since

  /// Whether it comes later: the earliest is on top of a queue.
  bool operator<(const CourseTouch& next) const
  {
    return std::tie(next.time, next.first, next.other) < std::tie(time, first, other);
  }
};
// [course_touch]

// [first_of]
/// Whether a body that is hit goes its own way: a ball, a swept box, and what falls. All others lie
/// among others: they are pushed in this step, and move in the next.
inline bool goes_on(const StepCourses& step, int i)
{
  const bool alone = is_ball(step.scene, i) || step.falls[place_of(i)] || is_swept_box(step, i);
  return alone && !is_fixed(*step.courses[place_of(i)].of);
}

/// Two bodies that touch, first the one that goes on by itself: a swept box before a ball, that
/// before all others; of two balls one that falls.
inline std::pair<int, int> first_of(const StepCourses& step, int i, int j)
{
  const auto rank = [&](int one)
  {
    const bool ball = is_ball(step.scene, one);
    return is_swept_box(step, one) ? 3 : ball && step.falls[place_of(one)] ? 2 : ball ? 1 : 0;
  };
  return rank(j) > rank(i) ? std::pair(j, i) : std::pair(i, j);
}

/// Has a box that can move be swept from now on.
inline void sweep_from_now(StepCourses& step, int box)
{
  if (!is_ball(step.scene, box) && !is_fixed(*step.courses[place_of(box)].of))
  {
    step.too_deep[place_of(box)] = true;
  }
}

/// Has a box that a solver has left too deep take along the box that it pressed on: where the one
/// went, it went because of the other.
inline void take_along(StepCourses& step, int first, int other)
{
  const bool deep_box = step.too_deep[place_of(first)] && !is_ball(step.scene, first);
  if (deep_box && pressed(step, std::minmax(first, other)))
  {
    sweep_from_now(step, other);
  }
}
// [first_of]

// [next_touch]
/// How deep [m] bodies may lie in each other that rest on each other in the middle of a step.
inline double rest_depth(const Scene& scene, int i, int j)
{
  return harmless_depth(scene, {i, j}) / 2;
}

/// When a body first touches another from a time [s] to the end of the step, as a share of it.
///
/// What presses on each other has been kept apart by a solver, more or less, and touches only where
/// it is deeper than that leaves it: a ball, where it is by `rest_depth` deeper than as the step
/// began. `depth` [m] is how deep two boxes may be that pass.
inline std::optional<SweptHit<double>>
next_touch(const StepCourses& step, int first, int other, double time, double depth)
{
  const Scene& scene = step.scene;
  const Course &course = step.courses[place_of(first)], &by = step.courses[place_of(other)];
  const auto& shape = scene.bodies[place_of(first)].shape;
  const auto& of_other = scene.bodies[place_of(other)].shape;
  const bool presses = pressed(step, std::minmax(first, other));
  if (is_ball(scene, first))
  {
    const auto at_first = [&]
    {
      const auto was = [&](int i)
      { return as_it_was(*step.courses[place_of(i)].of, start_of(step, i)); };
      const RigidBody ball = was(first), body = was(other);
      return std::max(0.0, depth_between(scene, {first, other}, ball, body));
    };
    const double allowed = presses ? at_first() + rest_depth(scene, first, other) : 0;
    const BallOnCourse ball{course, by, time, scene.step, allowed};
    return std::visit(ball, shape, of_other);
  }
  const double slack = presses ? harmless_depth(scene, {first, other}) : 0;
  return std::visit(
      BoxOnCourse{course, by, time, scene.step, std::max(slack, depth)}, shape, of_other);
}
// [next_touch]

} // namespace cookbook
