#pragma once

/// \file
/// \brief Which bodies may have passed through others in a step.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/sweeps/step_courses.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [in_danger]
/// The radius [m] of the smallest ball; infinite if there is none.
inline double smallest_ball(const StepCourses& step)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(step.scene.bodies.size()); ++i)
  {
    if (is_ball(step.scene, i) && !step.gone[place_of(i)])
    {
      smallest = std::min(smallest, reach(step.scene, i));
    }
  }
  return smallest;
}

/// Whether a ball may have passed through another body, or that through it: if it fell freely, has
/// ended too deep in something, or if the two went by more than its radius. What goes by less
/// cannot get behind a surface.
inline bool in_danger(const StepCourses& step, int ball, int other)
{
  const std::size_t i = place_of(ball);
  const double way = step.ways[i] + step.ways[place_of(other)];
  return is_ball(step.scene, ball) &&
         (step.falls[i] || step.too_deep[i] || way > reach(step.scene, ball));
}

/// All that a body may have touched in a step that ended at a pose.
inline Eigen::AlignedBox<double, 3>
bounds_on_way(const StepCourses& step, int i, const RigidBody& end)
{
  const Course& course = step.courses[place_of(i)];
  const auto& shape = step.scene.bodies[place_of(i)].shape;
  const double bulge = step.scene.step * step.scene.step / 8 * course.pull.acceleration.norm();
  const double turn = step.scene.step * course.spin.norm();
  const double wider = bulge + std::min(1.0, turn * turn / 8) * reach(step.scene, i);
  const auto axes = [&] { return course.from.orientation.toRotationMatrix(); };
  return bounds_at(course.from.motion.center, axes, shape, wider)
      .merged(bounds_of(end, shape, wider));
}

/// Whether two bodies may touch from a time [s] to the end of the step: whether, as they fly on,
/// their centres come nearer to each other than both reach, but for rounding.
inline bool may_meet(const StepCourses& step, int i, int j, double time)
{
  const auto is_plane = [&](int one)
  { return std::holds_alternative<PlaneShape>(step.scene.bodies[place_of(one)].shape); };
  if (is_plane(i) || is_plane(j))
  {
    return true;
  }
  const Course &a = step.courses[place_of(i)], &b = step.courses[place_of(j)];
  const double left = step.scene.step - time;
  const Vector3<double> apart = b.place_at(time) - a.place_at(time);
  const Vector3<double> way = left * (b.velocity_at(time) - a.velocity_at(time));
  const double bulge = left * left / 2 * (b.pull.acceleration - a.pull.acceleration).norm();
  const Vector3<double> ends[] = {apart, apart + way};
  const double nearest = nearest_on_segment(ends, 0, 1).point.norm();
  return !(nearest > (reach(step.scene, i) + reach(step.scene, j)) * (1 + 1e-9) + bulge);
}

/// The leaves of bodies that may have touched something outside of the bounds that pairs were found
/// by: a solver has pushed them there, or they were too fast.
[[gnu::flatten]] inline std::vector<std::size_t>
strays(const StepCourses& step, std::span<const RigidBody> ends)
{
  std::vector<std::size_t> found;
  const std::span<const Bounds> leaves = step.tree->leaves();
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    const int i = leaves[leaf].body;
    if (!leaves[leaf].box.contains(bounds_on_way(step, i, ends[place_of(i)])))
    {
      found.push_back(leaf);
    }
  }
  return found;
}

/// Calls `ask(i, j)` for all pairs of bodies that may have met, the smaller number first; then the
/// tree holds all that each may have touched.
template <class Ask>
void each_that_may_have_met(StepCourses& step, std::span<const RigidBody> ends, const Ask& ask)
{
  const auto way_of = [&](const Bounds& leaf)
  { return bounds_on_way(step, leaf.body, ends[place_of(leaf.body)]); };
  const std::vector<std::size_t> astray = strays(step, ends);
  if (8 * astray.size() > ends.size())
  {
    step.tree->refit(way_of);
    return each_overlap(*step.tree, ask);
  }
  std::vector<std::pair<int, int>> pairs(step.close_pairs.begin(), step.close_pairs.end());
  for (const std::size_t leaf : astray)
  {
    step.tree->widen(leaf, way_of(step.tree->leaves()[leaf]));
  }
  for (const std::size_t leaf : astray)
  {
    add_overlaps(*step.tree, leaf, pairs);
  }
  if (!astray.empty())
  {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }
  for (const auto& [i, j] : pairs)
  {
    ask(i, j);
  }
}

/// The pairs of bodies of which one may have passed through the other; then the tree holds all
/// that each may have touched.
inline std::vector<std::pair<int, int>>
pairs_in_danger(StepCourses& step, std::span<const RigidBody> ends)
{
  const double harmless = smallest_ball(step) / 2;
  const auto fast_or_deep = [&](int i)
  {
    const bool falling_ball = step.falls[place_of(i)] && is_ball(step.scene, i);
    return falling_ball || step.ways[place_of(i)] > harmless || is_fast_box(step, i) ||
           step.too_deep[place_of(i)];
  };
  bool any = false;
  for (int i = 0; i < static_cast<int>(ends.size()) && !any; ++i)
  {
    any = !step.gone[place_of(i)] && fast_or_deep(i);
  }
  std::vector<std::pair<int, int>> pairs;
  const auto ask = [&](int i, int j)
  {
    const bool danger = is_swept_box(step, i) || is_swept_box(step, j) || in_danger(step, i, j) ||
                        in_danger(step, j, i);
    if (danger && may_meet(step, i, j, 0))
    {
      pairs.emplace_back(i, j);
    }
  };
  if (any)
  {
    each_that_may_have_met(step, ends, ask);
  }
  return pairs;
}
// [in_danger]

// [pressed]
/// Whether two bodies, the smaller number first, pressed on each other: then the solver has kept
/// them apart, more or less.
inline bool pressed(const StepCourses& step, const std::pair<int, int>& pair)
{
  const auto before = [](const WorldContact& contact, const std::pair<int, int>& of)
  { return pair_of(contact) < of; };
  const auto found = std::lower_bound(step.contacts.begin(), step.contacts.end(), pair, before);
  return found != step.contacts.end() && pair_of(*found) == pair && presses(*found);
}
// [pressed]

} // namespace cookbook
