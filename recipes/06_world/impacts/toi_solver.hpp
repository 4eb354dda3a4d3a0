#pragma once

/// \file
/// \brief What bodies would pass through in a step: found in the order of time, and bounced off.

#include "06_world/impacts/toi_contact.hpp"
#include "06_world/impacts/toi_queue.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace cookbook
{

// [toi_solver]
/// Corrects a step in which bodies would have passed through something.
class ToiSolver
{
public:
  /// The step, the bodies at its end, and lists for the bodies that are hit, and for hit events.
  ToiSolver(
      StepTrajectories& step, std::span<RigidBody> ends, std::vector<int>& hit,
      std::vector<Impact>& impacts)
      : step_(step),
        ends_(ends),
        hit_(hit),
        impacts_(impacts),
        duration_(step.scene.step),
        substeps_(step, ends),
        queue_(step, ends)
  {
  }

  /// Has bodies bounce off what they touch, one touch after the other.
  void run()
  {
    for (const auto& [i, j] : ccd_pairs(step_, ends_))
    {
      queue_.enqueue(i, j, 0);
    }
    while (const std::optional<ToiEvent> event = queue_.next())
    {
      handle(*event);
    }
  }

private:
  RigidBody at(int i, double time) const
  {
    const bool free = step_.falls[index_of(i)] || queue_.has_changed(i);
    return state_at(step_, i, time, free, ends_[index_of(i)]);
  }

  /// Has two bodies bounce off each other, or lets them pass.
  void handle(const ToiEvent& event)
  {
    sweep_partner(step_, event.first, event.other);
    ToiContact one{event, at(event.first, event.time), at(event.other, event.time)};
    one.manifold = toi_manifold(step_.scene, event, one.a, one.b);
    one.sphere = is_sphere(step_.scene, event.first);
    if (let_pass(one))
    {
      return;
    }
    solve(one);
    queue_.touch(event.first, event.other, event.normal);
    if (!allow_resting(one))
    {
      resume_both(one);
    }
  }

  /// Lets two boxes through a little that are about to pass each other; whether they are.
  bool let_pass(const ToiContact& one)
  {
    const double depth = ghost_depth(step_, one.event, one.manifold, one.a, one.b);
    const bool passes = depth > queue_.allowed_overlap(one.pair());
    if (passes)
    {
      queue_.allow(one.pair(), depth);
      queue_.enqueue(one.event.first, one.event.other, one.event.time);
    }
    return passes;
  }

  /// Resolves an event, with the bodies that are pushed along; hits are counted.
  void solve(ToiContact& one)
  {
    const int first = one.event.first, other = one.event.other;
    substeps_.count_event(first);
    one.over_limit = substeps_.is_over_limit(first);
    one.clamped = substeps_.is_clamped(first);
    const double threshold = threshold_of(step_, one.event);
    const double threshold_speed =
        one.over_limit ? std::numeric_limits<double>::infinity()
                       : std::min(threshold, inner_radius(step_.scene, first) / (2 * duration_));
    const auto at_touch = [&](int i) { return at(i, one.event.time); };
    one.approach_speed = resolve_toi_island(
        step_, one.event, one.manifold, one.a, one.b, threshold_speed, at_touch, one.pushed);
    one.resting = one.approach_speed <= threshold_speed;
    if (one.approach_speed > threshold)
    {
      add_hit(step_.scene, one, impacts_);
      queue_.count_hit(first);
      queue_.count_hit(other);
      if (one.sphere && queue_.hits(other) > 2) // balls may have been stopped in its way
      {
        start_sweeping(step_, other);
      }
    }
  }

  /// Allows a box that comes to rest a little depth; whether it goes on as it did, since nothing
  /// was pushed.
  bool allow_resting(const ToiContact& one)
  {
    const int first = one.event.first, other = one.event.other;
    if (one.sphere || !one.resting || queue_.allowed_overlap(one.pair()) != 0)
    {
      return false;
    }
    queue_.allow(one.pair(), resting_depth(step_.scene, first, other));
    if (one.approach_speed == 0)
    {
      queue_.enqueue(first, other, one.event.time);
    }
    return one.approach_speed == 0;
  }

  /// Lets both go on, and the bodies that they have pushed along.
  void resume_both(ToiContact& one)
  {
    const auto& [time, first, other, normal, versions] = one.event;
    const ToiResponse response = response_of(step_, one);
    if (is_finished(step_, one, response))
    {
      queue_.drop(one.pair());
    }
    if (!one.sphere && (response == ToiResponse::no_rotation || response == ToiResponse::clamped))
    {
      const Vector3<double> point = toi_point(one.manifold, one.a);
      one.approach_speed = std::max(one.approach_speed, stop_center(one.a, one.b, normal, point));
    }
    const bool both = response == ToiResponse::no_rotation && is_swept_box(step_, other) &&
                      !substeps_.is_clamped(other);
    resume_first(one, response, both);
    const bool alike = both || response == ToiResponse::clamped;
    if (alike || one.approach_speed > 0)
    {
      substeps_.resume_other(other, one.b, time, alike ? response : ToiResponse::free);
    }
    if (both)
    {
      substeps_.block(other, one.b, one.event, one.manifold, response, 1);
    }
    if (one.approach_speed > 0)
    {
      hit_.insert(hit_.end(), {first, other});
    }
    for (const ToiBody& other_body : one.pushed)
    {
      queue_.count_hit(other_body.number);
      substeps_.resume_other(other_body.number, other_body.body, time, ToiResponse::free);
      hit_.push_back(other_body.number);
    }
    queue_.enqueue_all(substeps_.take_changed(time), time);
  }

  /// Has the first go on. If both are held it gives up its share, by its mass, of the speed at
  /// which they still close, and the other what is left. No ball is: it may be pinned to a wall.
  void resume_first(const ToiContact& one, ToiResponse response, bool both)
  {
    const auto& [time, first, other, normal, versions] = one.event;
    if (one.approach_speed > 0 || response != ToiResponse::free || !step_.falls[index_of(first)])
    {
      substeps_.resume(first, one.a, time, response);
    }
    if (response == ToiResponse::supported || response == ToiResponse::no_rotation)
    {
      const double masses = one.a.inverse_mass + one.b.inverse_mass;
      const double fraction = both ? one.a.inverse_mass / masses : 1;
      substeps_.block(first, one.a, one.event, one.manifold, response, fraction);
    }
  }

  StepTrajectories& step_;
  std::span<RigidBody> ends_;
  std::vector<int>& hit_;
  std::vector<Impact>& impacts_;
  double duration_;
  ToiSubsteps substeps_;
  ToiQueue queue_;
};
// [toi_solver]

} // namespace cookbook
