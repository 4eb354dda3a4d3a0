#pragma once

/// \file
/// \brief The touches of a step to come, the earliest first.

#include "06_world/impacts/next_touch.hpp"
#include "06_world/sweeps/too_deep.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [touch_queue]
/// A body that has been hit so often in a step is not looked at again with what it was left with: a
/// jam of bodies that nothing pulls would never end, each pair that was left being hit by another.
inline constexpr int most_hits_a_step = 512;

/// The touches of a step to come; those of a course that has changed since are forgotten.
class TouchQueue
{
public:
  /// Of these courses, and bodies where they end, which both may change.
  TouchQueue(const StepCourses& step, std::span<const RigidBody> ends)
      : step_(step),
        ends_(ends),
        versions_(step.courses.size(), 0),
        hits_(step.courses.size(), 0),
        leaf_(step.courses.size(), -1)
  {
    int leaf = 0;
    for (const Bounds& one : step.tree->leaves())
    {
      leaf_[place_of(one.body)] = leaf++;
    }
  }

  /// Writes down when two bodies touch, if they do so after a time [s].
  void look_for(int i, int j, double time)
  {
    const std::pair<int, int> pair = std::minmax(i, j);
    if (is_left(pair) || ignores(step_.scene, pair) || end_harmlessly(step_, ends_, pair))
    {
      return;
    }
    const auto [first, other] = first_of(step_, i, j);
    if (const auto hit = next_touch(step_, first, other, time, slack_of(pair)))
    {
      const double at = hit->time * step_.scene.step;
      touches_.push({at, first, other, hit->normal, versions(first, other)});
    }
  }

  /// Looks anew for what these bodies touch: their courses have changed at a time [s]. The last
  /// goes first, so that two that hit each other again and again take turns.
  void look_around(std::span<const int> changed, double time)
  {
    for (const int i : changed)
    {
      ++versions_[place_of(i)];
      if (leaf_[place_of(i)] >= 0)
      {
        step_.tree->widen(place_of(leaf_[place_of(i)]), way_of(i));
      }
    }
    for (std::size_t k = changed.size(); k-- > 0;)
    {
      look_around(changed[k], changed.subspan(k + 1), time);
    }
  }

  /// The next touch, which is taken out; nothing if there is none.
  std::optional<CourseTouch> next()
  {
    while (!touches_.empty())
    {
      CourseTouch touch = touches_.top();
      touches_.pop();
      if (touch.versions == versions(touch.first, touch.other))
      {
        return touch;
      }
    }
    return std::nullopt;
  }

  /// Whether a body's course has changed.
  bool has_changed(int i) const { return versions_[place_of(i)] > 0; }

  /// Two bodies that nobody looks at for the rest of the step, or until one of them comes back.
  void leave(const std::pair<int, int>& pair) { left_[pair] = hits(pair); }

  /// Looks at a body again with all that it had been left with: somebody has hit it.
  void come_back(int i) { hits_[place_of(i)] = std::min(hits_[place_of(i)] + 1, most_hits_a_step); }

  /// How often a body has been hit in this step, up to the most that counts.
  int hits(int i) const { return hits_[place_of(i)]; }

  /// Lets two boxes overlap by a little [m] for the rest of the step: they pass each other, or rest
  /// on each other.
  void allow(const std::pair<int, int>& pair, double depth) { slacks_[pair] = depth; }

  /// By how much [m] two boxes may overlap.
  double slack_of(const std::pair<int, int>& pair) const
  {
    const auto found = slacks_.find(pair);
    return found == slacks_.end() ? 0 : found->second;
  }

private:
  Eigen::AlignedBox<double, 3> way_of(int i) const
  {
    return bounds_on_way(step_, i, ends_[place_of(i)]);
  }
  /// Looks for what a body touches, but for those that have looked already.
  void look_around(int i, std::span<const int> done, double time)
  {
    const Eigen::AlignedBox<double, 3> way = way_of(i);
    const auto watched = [&](int one)
    { return is_ball(step_.scene, one) || is_swept_box(step_, one); };
    each_that(
        *step_.tree, [&](const Eigen::AlignedBox<double, 3>& box) { return box.intersects(way); },
        [&](int j)
        {
          const bool asked = j == i || std::find(done.begin(), done.end(), j) != done.end();
          if (!asked && (watched(i) || watched(j)) && may_meet(step_, i, j, time))
          {
            look_for(i, j, time);
          }
        });
  }
  bool is_left(const std::pair<int, int>& pair) const
  {
    const auto found = left_.find(pair);
    return found != left_.end() && found->second == hits(pair);
  }
  std::pair<int, int> hits(const std::pair<int, int>& pair) const { return of_both(hits_, pair); }
  std::pair<int, int> versions(int a, int b) const { return of_both(versions_, {a, b}); }
  static std::pair<int, int>
  of_both(const std::vector<int>& counts, const std::pair<int, int>& pair)
  {
    return {counts[place_of(pair.first)], counts[place_of(pair.second)]};
  }

  const StepCourses& step_;
  std::span<const RigidBody> ends_;
  std::vector<int> versions_; // how often each course has changed
  std::vector<int> hits_;     // how often each body has been hit, up to the most that counts
  std::vector<int> leaf_;     // each body's place among the leaves of the tree; -1 if it has none
  std::map<std::pair<int, int>, std::pair<int, int>> left_; // and how often they had been hit
  std::map<std::pair<int, int>, double> slacks_;
  std::priority_queue<CourseTouch> touches_;
};
// [touch_queue]

} // namespace cookbook
