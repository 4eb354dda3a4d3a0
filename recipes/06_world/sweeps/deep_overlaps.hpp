#pragma once

/// \file
/// \brief What has to be swept: boxes that went far, and what a solver has left too deep.

#include "06_world/sweeps/predicted_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [deep_overlaps]
/// A turn by an angle moves a unit quaternion by 2 sin(angle / 4), up to a whole turn by at least
/// the angle over this: more than pi.
inline constexpr double chord_bound = 3.15;

/// A solver has left bodies too deep at so many times the allowed penetration, which it may miss a
/// little where it does as it should.
inline constexpr double too_deep = 1.5;

/// How far [m] any point of each body went in a step, and up to 1.6 times as far: no sines.
inline void estimate_displacements(StepTrajectories& step, std::span<const RigidBody> ends)
{
  step.displacements.clear();
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    const SceneBody& start = step.scene.bodies[i];
    double displacement = (ends[i].motion.center - start.position).norm();
    if (!ends[i].is_sphere)
    {
      const auto from = start.orientation.coeffs(), to = ends[i].orientation.coeffs();
      const double chord =
          std::sqrt(std::min((to - from).squaredNorm(), (to + from).squaredNorm()));
      displacement += chord_bound * chord * bounding_radius(step.scene, static_cast<int>(i));
    }
    step.displacements.push_back(displacement);
  }
}

/// Whether two bodies end no deeper in each other than does harm, and nothing has to be known of
/// their ways: boxes that go by less than half of their size cannot get behind each other.
inline bool end_within_tolerance(
    const StepTrajectories& step, std::span<const RigidBody> ends, const std::pair<int, int>& pair)
{
  const auto is_slow_box = [&](int i)
  { return !is_sphere(step.scene, i) && !is_fast_box(step, i); };
  const auto [i, j] = pair;
  return is_slow_box(i) && is_slow_box(j) &&
         depth_between(step.scene, pair, ends[index_of(i)], ends[index_of(j)]) <=
             allowed_penetration(step.scene, pair);
}

/// Marks the bodies that a step has taken deeper into something than 7.5 % of the smaller size
/// of the two, and by more than a step of gravity, g h², and says whether there are any. Only
/// bodies are asked that were near each other.
inline bool find_deep_overlaps(
    StepTrajectories& step, std::span<const Prediction> prediction, std::span<const RigidBody> ends)
{
  const double fall = contact_margin(step.scene) / 2;
  bool any = false;
  step.needs_sweep.assign(ends.size(), false);
  const auto moved = [&](int i) { return step.displacements[index_of(i)] > 0; };
  for (const auto& [i, j] : step.close_pairs)
  {
    const double allowed_penetration = std::min(
        prediction[index_of(i)].allowed_penetration, prediction[index_of(j)].allowed_penetration);
    const double displacements = step.displacements[index_of(i)] + step.displacements[index_of(j)];
    if (!(displacements > allowed_penetration))
    {
      continue;
    }
    const auto end_of = [&](int one) -> const RigidBody& { return ends[index_of(one)]; };
    const auto was = [&](int one)
    { return with_state(ends[index_of(one)], start_state(step, one)); };
    const auto depth = [&, a = i, b = j](const auto& pose_of) {
      return depth_between(step.scene, {a, b}, pose_of(a), pose_of(b));
    };
    const double end = depth(end_of);
    if (end > allowed_penetration * too_deep &&
        end > depth(was) + std::max(allowed_penetration / deepening_parts, fall))
    {
      any = true;
      for (const int one : {i, j})
      {
        step.needs_sweep[index_of(one)] = step.needs_sweep[index_of(one)] || moved(one);
      }
    }
  }
  return any;
}

/// Whether any body but a sphere may have to be swept, or a sphere because it is too deep.
inline bool has_boxes_to_sweep(
    StepTrajectories& step, std::span<const Prediction> prediction, std::span<const RigidBody> ends)
{
  estimate_displacements(step, ends);
  bool any = find_deep_overlaps(step, prediction, ends);
  for (int i = 0; i < static_cast<int>(ends.size()) && !any; ++i)
  {
    any = is_fast_box(step, i);
  }
  return any;
}
// [deep_overlaps]

} // namespace cookbook
