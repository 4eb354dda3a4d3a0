#pragma once

/// \file
/// \brief How all bodies of a world went through a step, and which balls may have passed through
/// something.

#include "05_resolution/contacts/broad_phase.hpp"
#include "05_resolution/contacts/world_contact.hpp"
#include "05_resolution/sweeps/course.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [step_courses]
/// A step of a world as solvers and free fall had it.
struct StepCourses
{
  const Scene& scene;                     ///< with the bodies' shapes
  std::span<const WorldContact> contacts; ///< of this step
  const std::vector<bool>& falls;         ///< whether a body fell freely, pushed by nothing
  const std::vector<bool>& gone;          ///< whether it is no more
  std::vector<Course> courses = {};       ///< of all bodies
  std::vector<double> ways = {};          ///< [m], how far any point of a body went
};

/// True if a body is a ball.
inline bool is_ball(const StepCourses& step, int i)
{
  return std::holds_alternative<SphereShape>(step.scene.bodies[place_of(i)].shape);
}

/// How far [m] a body reaches from its centre.
inline double reach(const StepCourses& step, int i)
{
  return std::visit(
      [](const auto& shape) { return reach_of(shape); }, step.scene.bodies[place_of(i)].shape);
}

/// Writes down the courses of all bodies, from where a step began to where it ended.
inline void
set_out(StepCourses& step, std::span<const RigidBody> starts, std::span<const RigidBody> ends)
{
  const double duration = step.scene.step;
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const Course course = step.falls[i]
                              ? falling_course(starts[i], ends[i], duration, step.scene.gravity)
                              : straight_course(starts[i], ends[i], duration);
    const double turning = duration * course.spin.norm() * reach(step, static_cast<int>(i));
    step.ways.push_back((ends[i].position - starts[i].position).norm() + turning);
    step.courses.push_back(course);
  }
}
// [step_courses]

// [in_danger]
/// The radius [m] of the smallest ball; infinite if there is none.
inline double smallest_ball(const StepCourses& step)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(step.scene.bodies.size()); ++i)
  {
    if (is_ball(step, i) && !step.gone[place_of(i)])
    {
      smallest = std::min(smallest, reach(step, i));
    }
  }
  return smallest;
}

/// Whether a ball may have passed through another body, or that through it: if it fell freely, or
/// if the two went by more than its radius. What goes by less cannot get behind a surface.
inline bool in_danger(const StepCourses& step, int ball, int other)
{
  const double way = step.ways[place_of(ball)] + step.ways[place_of(other)];
  return is_ball(step, ball) && (step.falls[place_of(ball)] || way > reach(step, ball));
}

/// All that a body may have touched in a step that ended at a pose.
inline Bounds bounds_on_way(const StepCourses& step, int i, const RigidBody& end)
{
  const Course& course = step.courses[place_of(i)];
  const auto& shape = step.scene.bodies[place_of(i)].shape;
  const double bulge = step.scene.step * step.scene.step / 8 * course.acceleration.norm();
  const double wider = course.spin.isZero(0) ? bulge : bulge + reach(step, i);
  Bounds bounds{bounds_of(course.start, shape, wider), i};
  bounds.box.extend(bounds_of(end, shape, wider));
  return bounds;
}

/// The pairs of bodies of which one is a ball that may have passed through the other.
inline std::vector<std::pair<int, int>>
pairs_in_danger(const StepCourses& step, std::span<const RigidBody> ends)
{
  const double harmless = smallest_ball(step) / 2;
  const auto fast = [&](int i)
  {
    const bool falling_ball = step.falls[place_of(i)] && is_ball(step, i);
    return falling_ball || step.ways[place_of(i)] > harmless;
  };
  std::vector<Bounds> bounds;
  bool any = false;
  for (int i = 0; i < static_cast<int>(ends.size()); ++i)
  {
    if (!step.gone[place_of(i)])
    {
      bounds.push_back(bounds_on_way(step, i, ends[place_of(i)]));
      any = any || fast(i);
    }
  }
  std::vector<std::pair<int, int>> pairs;
  const auto ask = [&](int i, int j)
  {
    if ((fast(i) || fast(j)) && (in_danger(step, i, j) || in_danger(step, j, i)))
    {
      pairs.emplace_back(i, j);
    }
    return true;
  };
  if (any)
  {
    each_overlap(bounds, ask);
  }
  return pairs;
}
/// Whether two bodies may be close enough to touch from a time [s] to the end of the step.
inline bool may_meet(const StepCourses& step, int i, int j, double time)
{
  const double left = step.scene.step - time;
  const auto way = [&](const Course& of)
  { return left * (of.velocity_at(time).norm() + left * of.acceleration.norm()); };
  const Course &a = step.courses[place_of(i)], &b = step.courses[place_of(j)];
  const double near = reach(step, i) + reach(step, j) + way(a) + way(b);
  return std::holds_alternative<PlaneShape>(step.scene.bodies[place_of(i)].shape) ||
         std::holds_alternative<PlaneShape>(step.scene.bodies[place_of(j)].shape) ||
         (a.place_at(time) - b.place_at(time)).norm() <= near;
}
// [in_danger]

// [pressed]
/// Whether two bodies, the smaller number first, pressed on each other: then the solver has kept
/// them apart, more or less.
inline bool pressed(const StepCourses& step, const std::pair<int, int>& pair)
{
  const auto before = [](const WorldContact& contact, const std::pair<int, int>& of)
  { return std::pair(contact.a, contact.b) < of; };
  const auto found = std::lower_bound(step.contacts.begin(), step.contacts.end(), pair, before);
  if (found == step.contacts.end() || std::pair(found->a, found->b) != pair)
  {
    return false;
  }
  return std::any_of(
      found->points().begin(), found->points().end(),
      [](const WorldPoint& point) { return point.impulse > 0; });
}
// [pressed]

} // namespace cookbook
