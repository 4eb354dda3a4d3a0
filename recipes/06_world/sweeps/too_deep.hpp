#pragma once

/// \file
/// \brief What has to be swept: boxes that went far, and what a solver has left too deep.

#include "06_world/sweeps/foreseen.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [too_deep]
/// How far [m] any point of each body went in a step, and up to 1.6 times as far: no sines.
inline void find_rough_ways(StepCourses& step, std::span<const RigidBody> ends)
{
  step.ways.clear();
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const SceneBody& start = step.scene.bodies[i];
    double way = (ends[i].motion.center - start.position).norm();
    if (!ends[i].round)
    {
      // A turn by an angle moves a quaternion by a chord of at least the angle over pi.
      const auto from = start.orientation.coeffs(), to = ends[i].orientation.coeffs();
      const double chord =
          std::sqrt(std::min((to - from).squaredNorm(), (to + from).squaredNorm()));
      way += 3.15 * chord * reach(step.scene, static_cast<int>(i));
    }
    step.ways.push_back(way);
  }
}

/// Whether two bodies end no deeper in each other than does harm, and nothing has to be known of
/// their ways: boxes that go by less than half of their size cannot get behind each other.
inline bool end_harmlessly(
    const StepCourses& step, std::span<const RigidBody> ends, const std::pair<int, int>& pair)
{
  const auto is_slow_box = [&](int i) { return !is_ball(step.scene, i) && !is_fast_box(step, i); };
  const auto [i, j] = pair;
  return is_slow_box(i) && is_slow_box(j) &&
         depth_between(step.scene, pair, ends[place_of(i)], ends[place_of(j)]) <=
             harmless_depth(step.scene, pair);
}

/// Marks the bodies that a step has taken deeper into something than 7.5 % of the smaller size
/// of the two, and by more than a step of gravity, g h², and says whether there are any. Only
/// bodies are asked that were near each other.
inline bool
find_too_deep(StepCourses& step, std::span<const Ahead> ahead, std::span<const RigidBody> ends)
{
  const double fall = contact_margin(step.scene) / 2;
  bool any = false;
  step.too_deep.assign(ends.size(), false);
  const auto moved = [&](int i) { return step.ways[place_of(i)] > 0; };
  for (const auto& [i, j] : step.close_pairs)
  {
    const double harmless = std::min(ahead[place_of(i)].harmless, ahead[place_of(j)].harmless);
    const double ways = step.ways[place_of(i)] + step.ways[place_of(j)];
    if (!(ways > harmless))
    {
      continue;
    }
    const auto end_of = [&](int one) -> const RigidBody& { return ends[place_of(one)]; };
    const auto was = [&](int one) { return as_it_was(ends[place_of(one)], start_of(step, one)); };
    const auto depth = [&, a = i, b = j](const auto& pose_of) {
      return depth_between(step.scene, {a, b}, pose_of(a), pose_of(b));
    };
    const double end = depth(end_of);
    if (end > harmless * 3 / 2 && end > depth(was) + std::max(harmless / 10, fall))
    {
      any = true;
      for (const int one : {i, j})
      {
        step.too_deep[place_of(one)] = step.too_deep[place_of(one)] || moved(one);
      }
    }
  }
  return any;
}

/// Whether any box may have gone by more than half of its smallest size.
inline bool may_have_fast_boxes(const StepCourses& step)
{
  for (int i = 0; i < static_cast<int>(step.ways.size()); ++i)
  {
    if (is_fast_box(step, i))
    {
      return true;
    }
  }
  return false;
}

/// Whether any box may have to be swept, or a ball because it is too deep.
inline bool
has_boxes_to_sweep(StepCourses& step, std::span<const Ahead> ahead, std::span<const RigidBody> ends)
{
  find_rough_ways(step, ends);
  return find_too_deep(step, ahead, ends) || may_have_fast_boxes(step);
}
// [too_deep]

} // namespace cookbook
