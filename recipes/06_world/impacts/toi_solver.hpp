#pragma once

/// \file
/// \brief Time-of-impact events of a step, where bodies would pass through others, solved in order.

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
/// Corrects a step in which bodies would have passed through others.
class ToiSolver
{
public:
  /// The step, the bodies at its end, and lists for bodies that are hit and for hit events.
  ToiSolver(
      StepTrajectories& step, std::span<RigidBody> ends, std::vector<int>& hit,
      std::vector<Impact>& impacts)
      : step_(step),
        ends_(ends),
        hit_(hit),
        impacts_(impacts),
        substeps_(step, ends),
        queue_(step, ends)
  {
  }

  /// Handles all TOI events in the order of their times.
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

  /// Lets the two bodies of an event pass each other, or resolves it and has them go on.
  void handle(const ToiEvent& event)
  {
    sweep_partner(step_, event.first, event.other);
    ToiContact contact{event, at(event.first, event.time), at(event.other, event.time)};
    contact.manifold = toi_manifold(step_.scene, event, contact.a, contact.b);
    contact.sphere = is_sphere(step_.scene, event.first);
    if (let_pass(contact))
    {
      return;
    }
    solve(contact);
    queue_.touch(event.first, event.other, event.normal);
    if (!allow_resting(contact))
    {
      resume_both(contact);
    }
  }

  /// Allows two boxes that are about to pass each other a small overlap; whether they are.
  bool let_pass(const ToiContact& contact)
  {
    const double depth = ghost_depth(step_, contact.event, contact.manifold, contact.a, contact.b);
    const bool passes = depth > queue_.allowed_overlap(contact.pair());
    if (passes)
    {
      queue_.allow(contact.pair(), depth);
      queue_.enqueue(contact.event.first, contact.event.other, contact.event.time);
    }
    return passes;
  }

  /// Resolves an event, with the bodies that are pushed along, and counts hits.
  void solve(ToiContact& contact)
  {
    const int first = contact.event.first, other = contact.event.other;
    substeps_.count_event(first);
    contact.over_limit = substeps_.is_over_limit(first);
    contact.clamped = substeps_.is_clamped(first);
    const double threshold = threshold_of(step_, contact.event);
    const double slow =
        std::min(threshold, inner_radius(step_.scene, first) / (2 * step_.scene.step));
    const double threshold_speed =
        contact.over_limit ? std::numeric_limits<double>::infinity() : slow;
    contact.approach_speed = resolve_toi_island(
        step_, contact.event, contact.manifold, contact.a, contact.b, threshold_speed,
        [&](int i) { return at(i, contact.event.time); }, contact.pushed);
    contact.resting = contact.approach_speed <= threshold_speed;
    if (contact.approach_speed > threshold)
    {
      add_hit(step_.scene, contact, impacts_);
      queue_.count_hit(first);
      queue_.count_hit(other);
      if (contact.sphere && queue_.hits(other) > 2) // spheres may have been stopped in its path
      {
        start_sweeping(step_, other);
      }
    }
  }

  /// Allows a box that comes to rest a small depth; whether it goes on, since no impulse acted.
  bool allow_resting(const ToiContact& contact)
  {
    const int first = contact.event.first, other = contact.event.other;
    if (contact.sphere || !contact.resting || queue_.allowed_overlap(contact.pair()) != 0)
    {
      return false;
    }
    queue_.allow(contact.pair(), resting_depth(step_.scene, first, other));
    if (contact.approach_speed == 0)
    {
      queue_.enqueue(first, other, contact.event.time);
    }
    return contact.approach_speed == 0;
  }

  /// Has both bodies go on, and those that they have pushed along.
  void resume_both(ToiContact& contact)
  {
    const auto& [time, first, other, normal, versions] = contact.event;
    const ToiResponse response = response_of(step_, contact);
    if (is_finished(step_, contact, response))
    {
      queue_.drop(contact.pair());
    }
    const bool blocked = response == ToiResponse::no_rotation;
    const bool clamped = response == ToiResponse::clamped;
    if (!contact.sphere && (blocked || clamped))
    {
      const Vector3<double> point = toi_point(contact.manifold, contact.a);
      contact.approach_speed =
          std::max(contact.approach_speed, stop_center(contact.a, contact.b, normal, point));
    }
    const bool both = blocked && is_swept_box(step_, other) && !substeps_.is_clamped(other);
    resume_first(contact, response, both);
    const bool alike = both || clamped;
    if (alike || contact.approach_speed > 0)
    {
      substeps_.resume_other(other, contact.b, time, alike ? response : ToiResponse::free);
    }
    if (both)
    {
      substeps_.block(other, contact.b, contact.event, contact.manifold, response, 1);
    }
    if (contact.approach_speed > 0)
    {
      hit_.insert(hit_.end(), {first, other});
    }
    for (const ToiBody& other_body : contact.pushed)
    {
      queue_.count_hit(other_body.number);
      substeps_.resume_other(other_body.number, other_body.body, time, ToiResponse::free);
      hit_.push_back(other_body.number);
    }
    queue_.enqueue_all(substeps_.take_changed(time), time);
  }

  /// Has the first body go on. If both are blocked, each gives up its part, by the masses, of the
  /// speed at which they still approach. No sphere is blocked: it may be pinned to a wall.
  void resume_first(const ToiContact& contact, ToiResponse response, bool both)
  {
    const auto& [time, first, other, normal, versions] = contact.event;
    if (contact.approach_speed > 0 || response != ToiResponse::free ||
        !step_.falls[index_of(first)])
    {
      substeps_.resume(first, contact.a, time, response);
    }
    if (response == ToiResponse::supported || response == ToiResponse::no_rotation)
    {
      const double masses = contact.a.inverse_mass + contact.b.inverse_mass;
      const double fraction = both ? contact.a.inverse_mass / masses : 1;
      substeps_.block(first, contact.a, contact.event, contact.manifold, response, fraction);
    }
  }

  StepTrajectories& step_;
  std::span<RigidBody> ends_;
  std::vector<int>& hit_;
  std::vector<Impact>& impacts_;
  ToiSubsteps substeps_;
  ToiQueue queue_;
};
// [toi_solver]

} // namespace cookbook
