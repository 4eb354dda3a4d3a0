#pragma once

/// \file
/// \brief The touches of a step to come, the earliest first.

#include "06_world/impacts/touched_surfaces.hpp"
#include "06_world/sweeps/deep_overlaps.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [toi_queue]
/// A body that has been hit so often in a step is not looked at again with what it was left with: a
/// jam of bodies that nothing pulls would never end, each pair that was left being hit by another.
inline constexpr int max_hits = 512;

/// The touches of a step to come; those of a course that has changed since are forgotten.
class ToiQueue
{
public:
  /// Of these courses, and bodies where they end, which both may change.
  ToiQueue(const StepTrajectories& step, std::span<const RigidBody> ends)
      : step_(step),
        surfaces_(step),
        ends_(ends),
        versions_(step.trajectories.size(), 0),
        hits_(step.trajectories.size(), 0),
        leaf_(step.trajectories.size(), -1)
  {
    int leaf = 0;
    for (const Bounds& one : step.tree->leaves())
    {
      leaf_[index_of(one.body)] = leaf++;
    }
  }

  /// Writes down when two bodies touch, if they do so after a time [s].
  void enqueue(int i, int j, double time)
  {
    const std::pair<int, int> pair = std::minmax(i, j);
    if (is_dropped(pair) || never_touch(step_.scene, ends_, pair) ||
        end_within_tolerance(step_, ends_, pair))
    {
      return;
    }
    const auto [first, other] = moving_first(step_, i, j);
    if (const auto hit = next_hit(first, other, time))
    {
      const double at = hit->time * step_.scene.step;
      queue_.push({at, first, other, hit->normal, versions(first, other)});
    }
  }

  /// Looks anew for what these bodies touch: their courses have changed at a time [s]. The last
  /// goes first, so that two that hit each other again and again take turns.
  void enqueue_all(std::span<const int> changed, double time)
  {
    for (const int i : changed)
    {
      ++versions_[index_of(i)];
      if (leaf_[index_of(i)] >= 0)
      {
        step_.tree->enlarge(index_of(leaf_[index_of(i)]), swept_bounds_of(i));
      }
    }
    for (std::size_t k = changed.size(); k-- > 0;)
    {
      enqueue_all(changed[k], changed.subspan(k + 1), time);
    }
  }

  /// The next touch, which is taken out; nothing if there is none.
  std::optional<ToiEvent> next()
  {
    while (!queue_.empty())
    {
      ToiEvent event = queue_.top();
      queue_.pop();
      if (event.versions == versions(event.first, event.other))
      {
        return event;
      }
    }
    return std::nullopt;
  }

  /// Takes down that a body touches another, along a normal from it to that.
  void touch(int first, int other, const Vector3<double>& normal)
  {
    surfaces_.add(first, other, normal);
  }

  /// Whether a body's course has changed.
  bool has_changed(int i) const { return versions_[index_of(i)] > 0; }

  /// Drops a pair for the rest of the step, or until one of the two is hit.
  void drop(const std::pair<int, int>& pair) { dropped_[pair] = hits(pair); }

  /// Counts a hit of a body, which ends drop() for all of its pairs.
  void count_hit(int i) { hits_[index_of(i)] = std::min(hits_[index_of(i)] + 1, max_hits); }

  /// How often a body has been hit in this step, up to the most that counts.
  int hits(int i) const { return hits_[index_of(i)]; }

  /// Lets two boxes overlap by a little [m] for the rest of the step: they pass each other, or rest
  /// on each other.
  void allow(const std::pair<int, int>& pair, double depth) { allowed_overlaps_[pair] = depth; }

  /// By how much [m] two boxes may overlap.
  double allowed_overlap(const std::pair<int, int>& pair) const
  {
    const auto found = allowed_overlaps_.find(pair);
    return found == allowed_overlaps_.end() ? 0 : found->second;
  }

private:
  Eigen::AlignedBox<double, 3> swept_bounds_of(int i) const
  {
    return swept_bounds(step_, i, ends_[index_of(i)]);
  }
  /// Looks for what a body touches, but for those that have looked already.
  void enqueue_all(int i, std::span<const int> done, double time)
  {
    const Eigen::AlignedBox<double, 3> displacement = swept_bounds_of(i);
    const auto is_swept = [&](int one)
    { return is_sphere(step_.scene, one) || is_swept_box(step_, one); };
    each_that(
        *step_.tree,
        [&](const Eigen::AlignedBox<double, 3>& box) { return box.intersects(displacement); },
        [&](int j)
        {
          const bool skip = j == i || std::find(done.begin(), done.end(), j) != done.end();
          if (!skip && (is_swept(i) || is_swept(j)) && may_touch(step_, i, j, time))
          {
            enqueue(i, j, time);
          }
        });
  }
  /// When the first touches the other; not at a seam of a surface that it touches.
  std::optional<SweptHit<double>> next_hit(int first, int other, double time)
  {
    const double allowed = allowed_overlap(std::minmax(first, other));
    const auto hit = next_toi(step_, first, other, time, allowed);
    const std::optional<double> depth =
        hit ? surfaces_.depth(first, other, hit->time * step_.scene.step) : std::nullopt;
    return depth ? next_toi(step_, first, other, time, allowed, depth) : hit;
  }
  bool is_dropped(const std::pair<int, int>& pair) const
  {
    const auto found = dropped_.find(pair);
    return found != dropped_.end() && found->second == hits(pair);
  }
  std::pair<int, int> hits(const std::pair<int, int>& pair) const { return of_both(hits_, pair); }
  std::pair<int, int> versions(int a, int b) const { return of_both(versions_, {a, b}); }
  static std::pair<int, int>
  of_both(const std::vector<int>& counts, const std::pair<int, int>& pair)
  {
    return {counts[index_of(pair.first)], counts[index_of(pair.second)]};
  }

  const StepTrajectories& step_;
  TouchedSurfaces surfaces_;
  std::span<const RigidBody> ends_;
  std::vector<int> versions_; // how often each course has changed
  std::vector<int> hits_;     // how often each body has been hit, up to the most that counts
  std::vector<int> leaf_;     // each body's place among the leaves of the tree; -1 if it has none
  std::map<std::pair<int, int>, std::pair<int, int>> dropped_; // and how often they had been hit
  std::map<std::pair<int, int>, double> allowed_overlaps_;
  std::priority_queue<ToiEvent> queue_;
};
// [toi_queue]

} // namespace cookbook
