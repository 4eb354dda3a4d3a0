#pragma once

/// \file
/// \brief What bodies would pass through in a step: found in the order of time, and bounced off.

#include "05_resolution/sweeps/going_on.hpp"
#include "05_resolution/sweeps/impact_group.hpp"
#include "05_resolution/sweeps/touch_queue.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [step_sweeps]
/// The most touches of a body in a step; from then on it only stops, and a box does not turn; after
/// as many more it stays where it is.
inline constexpr int most_touches_a_step = 64;

/// Corrects a step in which bodies would have passed through something.
class StepSweeps
{
public:
  /// The step, the bodies at its end, and a list that is given all that are hit.
  StepSweeps(StepCourses& step, std::span<RigidBody> ends, std::vector<int>& hit)
      : step_(step),
        ends_(ends),
        hit_(hit),
        duration_(step.scene.step),
        touched_(ends.size(), 0),
        onward_(step, ends),
        touches_(step, ends)
  {
  }

  /// Has bodies bounce off what they touch, one touch after the other.
  void run()
  {
    for (const auto& [i, j] : pairs_in_danger(step_, ends_))
    {
      touches_.look_for(i, j, 0);
    }
    while (const std::optional<CourseTouch> touch = touches_.next())
    {
      meet(*touch);
    }
  }

private:
  RigidBody at(int i, double time) const
  {
    const bool own = step_.falls[place_of(i)] || touches_.has_changed(i);
    return on_the_way(step_, i, time, own, ends_[place_of(i)]);
  }

  /// A body that has touched something so often that it stays where it is.
  bool is_frozen(int i) const { return touched_[place_of(i)] > 2 * most_touches_a_step; }

  void meet(const CourseTouch& touch)
  {
    const int first = touch.first, other = touch.other;
    const std::pair<int, int> pair = std::minmax(first, other);
    take_along(step_, first, other);
    RigidBody a = at(first, touch.time), b = at(other, touch.time);
    const Met met = touch_manifold(step_.scene, touch, a, b);
    const double depth = ghost_depth(step_.scene, touch, met, a, b);
    if (depth > touches_.slack_of(pair))
    {
      touches_.allow(pair, depth);
      touches_.look_for(first, other, touch.time);
      return;
    }
    const bool ball = is_ball(step_.scene, first), other_is_ball = is_ball(step_.scene, other);
    const bool tired = ++touched_[place_of(first)] > most_touches_a_step;
    const double threshold = threshold_of(step_, touch);
    const double slow = tired ? std::numeric_limits<double>::infinity()
                              : std::min(threshold, thinness(step_.scene, first) / (2 * duration_));
    const auto at_touch = [&](int i) { return at(i, touch.time); };
    std::vector<StruckBody> driven;
    double approach = bounce_together(step_, touch, met, a, b, slow, at_touch, driven);
    if (approach > threshold)
    {
      touches_.come_back(first);
      touches_.come_back(other);
      if (ball && touches_.hits(other) > 2) // balls may have been stopped in its way
      {
        sweep_from_now(step_, other);
      }
    }
    const bool rests = approach <= slow,
               leans = rests && (ball || !tired) && !goes_on(step_, other);
    if (!ball && rests && touches_.slack_of(pair) == 0)
    {
      touches_.allow(pair, rest_depth(step_.scene, first, other));
      if (approach == 0)
      {
        touches_.look_for(first, other, touch.time);
        return;
      }
    }
    // What has come to rest leans on what does not give way, but not a ball on a ball: what they
    // sink by, the next step finds. A box that touches and is not pushed is held. Who touches on
    // and on is frozen, and with it whatever touches it.
    const bool held = !ball && (tired || approach == 0);
    const bool frozen = is_frozen(first);
    if (held)
    {
      approach = std::max(approach, stop_center(a, b, touch.normal, place_of_touch(met, a)));
    }
    if (frozen || (ball && rests && !leans && (tired || approach == 0 || other_is_ball)))
    {
      touches_.leave(pair);
    }
    const Onward how = frozen  ? Onward::frozen
                       : held  ? Onward::held
                       : leans ? Onward::leans
                               : Onward::free;
    // A box that is in the way is held, too: the first gives up its share, by its mass, of the
    // speed at which they still close, and the other what is left. No ball is: it may be pinned to
    // a wall.
    const bool both = how == Onward::held && is_swept_box(step_, other) && !is_frozen(other);
    const double share = both ? a.inverse_mass / (a.inverse_mass + b.inverse_mass) : 1;
    if (approach > 0 || how != Onward::free || !step_.falls[place_of(first)])
    {
      onward_.go_on(first, a, touch.time, how);
    }
    if (how == Onward::leans || how == Onward::held)
    {
      onward_.hold(first, a, touch, met, how, share);
    }
    if (approach > 0)
    {
      hit_.insert(hit_.end(), {first, other});
    }
    if (approach > 0 || frozen || both)
    {
      pass_on(other, b, touch.time, frozen || both ? how : Onward::free);
    }
    if (both)
    {
      onward_.hold(other, b, touch, met, how, 1);
    }
    for (const StruckBody& one : driven)
    {
      touches_.come_back(one.number);
      pass_on(one.number, one.body, touch.time, Onward::free);
      hit_.push_back(one.number);
    }
    touches_.look_around(onward_.take_changed(touch.time), touch.time);
  }

  /// Has a body that is hit go on, or only takes down its velocities.
  void pass_on(int i, const RigidBody& body, double time, Onward how)
  {
    if (goes_on(step_, i))
    {
      return onward_.go_on(i, body, time, is_frozen(i) ? Onward::frozen : how);
    }
    Motion<double>& end = ends_[place_of(i)].motion;
    end = {end.center, body.motion.velocity, body.motion.angular_velocity};
  }

  StepCourses& step_;
  std::span<RigidBody> ends_;
  std::vector<int>& hit_;
  double duration_;
  std::vector<int> touched_; // how often each body has touched something
  GoingOn onward_;
  TouchQueue touches_;
};
// [step_sweeps]

} // namespace cookbook
