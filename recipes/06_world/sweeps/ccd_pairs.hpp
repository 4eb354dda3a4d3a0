#pragma once

/// \file
/// \brief Which bodies may have passed through others in a step.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/sweeps/step_trajectories.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [ccd_pairs]
/// The radius [m] of the smallest ball; infinite if there is none.
inline double smallest_sphere(const StepTrajectories& step)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < static_cast<int>(step.scene.bodies.size()); ++i)
  {
    if (is_sphere(step.scene, i) && !step.removed[index_of(i)])
    {
      smallest = std::min(smallest, bounding_radius(step.scene, i));
    }
  }
  return smallest;
}

/// Whether a ball may have passed through another body, or that through it: if it fell freely, has
/// ended too deep in something, or if the two went by more than its radius. What goes by less
/// cannot get behind a surface.
inline bool needs_ccd(const StepTrajectories& step, int sphere, int other)
{
  const std::size_t i = index_of(sphere);
  const double displacement = step.displacements[i] + step.displacements[index_of(other)];
  return is_sphere(step.scene, sphere) && (step.falls[i] || step.needs_sweep[i] ||
                                           displacement > bounding_radius(step.scene, sphere));
}

/// All that a body may have touched in a step that ended at a pose.
inline Eigen::AlignedBox<double, 3>
swept_bounds(const StepTrajectories& step, int i, const RigidBody& end)
{
  const Trajectory& trajectory = step.trajectories[index_of(i)];
  const auto& shape = step.scene.bodies[index_of(i)].shape;
  const double bulge =
      step.scene.step * step.scene.step / 8 * trajectory.external.acceleration.norm();
  const double rotation = step.scene.step * trajectory.spin.norm();
  const double wider =
      bulge + std::min(1.0, rotation * rotation / 8) * bounding_radius(step.scene, i);
  const Pose start{trajectory.from.motion.center, trajectory.from.orientation.toRotationMatrix()};
  return bounds_at(start, shape, wider).merged(bounds_of(end, shape, wider));
}

/// Whether two bodies may touch from a time [s] to the end of the step: whether, as they fly on,
/// their centres come nearer to each other than both reach, but for rounding.
inline bool may_touch(const StepTrajectories& step, int i, int j, double time)
{
  const auto is_plane = [&](int one)
  { return std::holds_alternative<PlaneShape>(step.scene.bodies[index_of(one)].shape); };
  if (is_plane(i) || is_plane(j))
  {
    return true;
  }
  const Trajectory &a = step.trajectories[index_of(i)], &b = step.trajectories[index_of(j)];
  const double left = step.scene.step - time;
  const Vector3<double> separation = b.place_at(time) - a.place_at(time);
  const Vector3<double> displacement = left * (b.velocity_at(time) - a.velocity_at(time));
  const double bulge = left * left / 2 * (b.external.acceleration - a.external.acceleration).norm();
  const Vector3<double> ends[] = {separation, separation + displacement};
  const double nearest = nearest_on_segment(ends, 0, 1).point.norm();
  return !(
      nearest >
      (bounding_radius(step.scene, i) + bounding_radius(step.scene, j)) * (1 + length_rounding) +
          bulge);
}

/// The leaves of bodies that may have touched something outside of the bounds that pairs were found
/// by: a solver has pushed them there, or they were too fast.
[[gnu::flatten]] inline std::vector<std::size_t>
escaped_leaves(const StepTrajectories& step, std::span<const RigidBody> ends)
{
  std::vector<std::size_t> found;
  const std::span<const Bounds> leaves = step.tree->leaves();
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    const int i = leaves[leaf].body;
    if (!leaves[leaf].box.contains(swept_bounds(step, i, ends[index_of(i)])))
    {
      found.push_back(leaf);
    }
  }
  return found;
}

/// Calls `ask(i, j)` for all pairs of bodies that may have met, the smaller number first; then the
/// tree holds all that each may have touched.
template <class Ask>
void each_swept_overlap(StepTrajectories& step, std::span<const RigidBody> ends, const Ask& ask)
{
  const auto swept_bounds_of = [&](const Bounds& leaf)
  { return swept_bounds(step, leaf.body, ends[index_of(leaf.body)]); };
  const std::vector<std::size_t> escaped = escaped_leaves(step, ends);
  if (8 * escaped.size() > ends.size())
  {
    step.tree->refit(swept_bounds_of);
    return each_overlap(*step.tree, ask);
  }
  std::vector<std::pair<int, int>> pairs(step.close_pairs.begin(), step.close_pairs.end());
  for (const std::size_t leaf : escaped)
  {
    step.tree->enlarge(leaf, swept_bounds_of(step.tree->leaves()[leaf]));
  }
  for (const std::size_t leaf : escaped)
  {
    add_overlaps(*step.tree, leaf, pairs);
  }
  if (!escaped.empty())
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
ccd_pairs(StepTrajectories& step, std::span<const RigidBody> ends)
{
  const double close_pass = smallest_sphere(step) / 2; // [m]: two that go by no more stay in reach
  const auto fast_or_deep = [&](int i)
  {
    const bool falling_ball = step.falls[index_of(i)] && is_sphere(step.scene, i);
    return falling_ball || step.displacements[index_of(i)] > close_pass || is_fast_box(step, i) ||
           step.needs_sweep[index_of(i)];
  };
  bool any = false;
  for (int i = 0; i < static_cast<int>(ends.size()) && !any; ++i)
  {
    any = !step.removed[index_of(i)] && fast_or_deep(i);
  }
  std::vector<std::pair<int, int>> pairs;
  const auto ask = [&](int i, int j)
  {
    const bool needed = is_swept_box(step, i) || is_swept_box(step, j) || needs_ccd(step, i, j) ||
                        needs_ccd(step, j, i);
    if (needed && may_touch(step, i, j, 0))
    {
      pairs.emplace_back(i, j);
    }
  };
  if (any)
  {
    each_swept_overlap(step, ends, ask);
  }
  return pairs;
}
// [ccd_pairs]

// [was_active]
/// Whether two bodies, the smaller number first, pressed on each other: then the solver has kept
/// them apart, more or less.
inline bool pressed(const StepTrajectories& step, const std::pair<int, int>& pair)
{
  const auto before = [](const WorldContact& contact, const std::pair<int, int>& of)
  { return pair_of(contact) < of; };
  const auto found = std::lower_bound(step.contacts.begin(), step.contacts.end(), pair, before);
  return found != step.contacts.end() && pair_of(*found) == pair && is_touching(*found);
}
// [was_active]

} // namespace cookbook
