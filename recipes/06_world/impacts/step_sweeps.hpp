#pragma once

/// \file
/// \brief What bodies would pass through in a step: found in the order of time, and bounced off.

#include "06_world/impacts/encounter.hpp"
#include "06_world/impacts/touch_queue.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace cookbook
{

// [step_sweeps]
/// Corrects a step in which bodies would have passed through something.
class StepSweeps
{
public:
  /// The step, the bodies at its end, and lists that are given all that are hit, and by whom.
  StepSweeps(
      StepCourses& step, std::span<RigidBody> ends, std::vector<int>& hit,
      std::vector<Impact>& impacts)
      : step_(step),
        ends_(ends),
        hit_(hit),
        impacts_(impacts),
        duration_(step.scene.step),
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

  void meet(const CourseTouch& touch)
  {
    take_along(step_, touch.first, touch.other);
    Encounter one{touch, at(touch.first, touch.time), at(touch.other, touch.time)};
    one.met = touch_manifold(step_.scene, touch, one.a, one.b);
    one.ball = is_ball(step_.scene, touch.first);
    if (pass(one))
    {
      return;
    }
    strike(one);
    if (!settle(one))
    {
      part(one);
    }
  }

  /// Lets two boxes through a little that are about to pass each other; whether they are.
  bool pass(const Encounter& one)
  {
    const double depth = ghost_depth(step_, one.touch, one.met, one.a, one.b);
    const bool passes = depth > touches_.slack_of(one.pair());
    if (passes)
    {
      touches_.allow(one.pair(), depth);
      touches_.look_for(one.touch.first, one.touch.other, one.touch.time);
    }
    return passes;
  }

  /// Lets two bodies bounce, with whom they drive along; who is hit is looked at again with all
  /// others.
  void strike(Encounter& one)
  {
    const int first = one.touch.first, other = one.touch.other;
    onward_.count_touch(first);
    one.tired = onward_.is_tired(first);
    one.frozen = onward_.is_frozen(first);
    const double threshold = threshold_of(step_, one.touch);
    const double slow = one.tired
                            ? std::numeric_limits<double>::infinity()
                            : std::min(threshold, thinness(step_.scene, first) / (2 * duration_));
    const auto at_touch = [&](int i) { return at(i, one.touch.time); };
    one.approach =
        bounce_together(step_, one.touch, one.met, one.a, one.b, slow, at_touch, one.driven);
    one.rests = one.approach <= slow;
    if (one.approach > threshold)
    {
      hear(step_.scene, one, impacts_);
      touches_.come_back(first);
      touches_.come_back(other);
      if (one.ball && touches_.hits(other) > 2) // balls may have been stopped in its way
      {
        sweep_from_now(step_, other);
      }
    }
  }

  /// Allows a box that comes to rest a little depth; whether it goes on as it did, since nothing
  /// was pushed.
  bool settle(const Encounter& one)
  {
    const int first = one.touch.first, other = one.touch.other;
    if (one.ball || !one.rests || touches_.slack_of(one.pair()) != 0)
    {
      return false;
    }
    touches_.allow(one.pair(), rest_depth(step_.scene, first, other));
    if (one.approach == 0)
    {
      touches_.look_for(first, other, one.touch.time);
    }
    return one.approach == 0;
  }

  /// Has both go on, and whom they have driven along.
  void part(Encounter& one)
  {
    const auto& [time, first, other, normal, versions] = one.touch;
    const Onward how = onward(step_, one);
    if (are_done(step_, one, how))
    {
      touches_.leave(one.pair());
    }
    if (!one.ball && (how == Onward::held || how == Onward::frozen))
    {
      const Vector3<double> place = place_of_touch(one.met, one.a);
      one.approach = std::max(one.approach, stop_center(one.a, one.b, normal, place));
    }
    const bool both =
        how == Onward::held && is_swept_box(step_, other) && !onward_.is_frozen(other);
    send_first(one, how, both);
    const bool alike = both || how == Onward::frozen;
    if (alike || one.approach > 0)
    {
      onward_.pass_on(other, one.b, time, alike ? how : Onward::free);
    }
    if (both)
    {
      onward_.hold(other, one.b, one.touch, one.met, how, 1);
    }
    if (one.approach > 0)
    {
      hit_.insert(hit_.end(), {first, other});
    }
    for (const StruckBody& struck : one.driven)
    {
      touches_.come_back(struck.number);
      onward_.pass_on(struck.number, struck.body, time, Onward::free);
      hit_.push_back(struck.number);
    }
    touches_.look_around(onward_.take_changed(time), time);
  }

  /// Has the first go on. If both are held it gives up its share, by its mass, of the speed at
  /// which they still close, and the other what is left. No ball is: it may be pinned to a wall.
  void send_first(const Encounter& one, Onward how, bool both)
  {
    const auto& [time, first, other, normal, versions] = one.touch;
    if (one.approach > 0 || how != Onward::free || !step_.falls[place_of(first)])
    {
      onward_.go_on(first, one.a, time, how);
    }
    if (how == Onward::leans || how == Onward::held)
    {
      const double masses = one.a.inverse_mass + one.b.inverse_mass;
      const double share = both ? one.a.inverse_mass / masses : 1;
      onward_.hold(first, one.a, one.touch, one.met, how, share);
    }
  }

  StepCourses& step_;
  std::span<RigidBody> ends_;
  std::vector<int>& hit_;
  std::vector<Impact>& impacts_;
  double duration_;
  GoingOn onward_;
  TouchQueue touches_;
};
// [step_sweeps]

} // namespace cookbook
