#pragma once

/// \file
/// \brief How a body goes on from a touch, for the rest of a step.

#include "06_world/impacts/toi_impulse.hpp"
#include "06_world/impacts/trajectory_state.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [toi_substeps]
/// A body is turned back where it goes against its velocity by more than this fraction of the
/// faster one: twice what a bounce of a group leaves undone.
inline constexpr double reversing_fraction = 0.02;

/// Whether a body that goes one way is turned back by going another [m/s]: not by rounding.
inline bool reverses(const Vector3<double>& before, const Vector3<double>& after)
{
  return -after.dot(before) >
         reversing_fraction * std::max(before.squaredNorm(), after.squaredNorm());
}

/// Takes out of the course of one of two bodies that touch a fraction of the speed at which it
/// leads into the other, and all of its acceleration that does: at the points where a box touches,
/// at the centre of a ball, or where there are none.
inline void remove_approach(
    StepTrajectories& step, const ToiEvent& event, const ToiManifold& manifold, int i,
    const RigidBody& body, double fraction)
{
  const bool is_first = i == event.first;
  const Vector3<double> normal = is_first ? event.normal : -event.normal;
  const Trajectory& other = step.trajectories[index_of(is_first ? event.other : event.first)];
  Trajectory& trajectory = step.trajectories[index_of(i)];
  double inward_speed = 0;
  const auto measure = [&](const Vector3<double>& point)
  {
    const Vector3<double> closing =
        trajectory.velocity_of(point, event.time) - other.velocity_of(point, event.time);
    inward_speed = std::max(inward_speed, closing.dot(normal));
  };
  if (body.is_sphere || !manifold)
  {
    measure(body.motion.center);
  }
  else
  {
    for (const ContactPoint<double>& point : manifold->points)
    {
      measure(point.position);
    }
  }
  trajectory.velocity -= fraction * inward_speed * normal;
  Vector3<double>& acceleration = trajectory.external.acceleration;
  acceleration -= std::max(0.0, acceleration.dot(normal)) * normal;
}

/// The most touches of a body in a step; from then on it only stops, and a box does not turn; after
/// as many more it stays where it is.
inline constexpr int max_toi_events = 64;

/// Moves bodies on after touches; knows which have moved on, and how often each was the first to
/// touch.
class ToiSubsteps
{
public:
  /// A step, and the bodies at its end.
  ToiSubsteps(StepTrajectories& step, std::span<RigidBody> ends)
      : step_(step), ends_(ends), event_counts_(ends.size(), 0), is_blocked_(ends.size(), false)
  {
  }

  void count_event(int i) { ++event_counts_[index_of(i)]; } ///< of the body that goes first
  /// Whether a body has touched so often that it only stops.
  bool is_over_limit(int i) const { return event_counts_[index_of(i)] > max_toi_events; }
  /// Whether it has so often that it stays where it is.
  bool is_clamped(int i) const { return event_counts_[index_of(i)] > 2 * max_toi_events; }

  /// Lets a body go on from where it is at a time [s] of the step.
  void resume(int i, const RigidBody& body, double time, ToiResponse response)
  {
    Trajectory& trajectory = step_.trajectories[index_of(i)];
    const Vector3<double> before = trajectory.velocity_at(time);
    const bool again = response == ToiResponse::no_rotation && is_blocked_[index_of(i)];
    is_blocked_[index_of(i)] = response == ToiResponse::no_rotation;
    trajectory.from = state_of(body);
    trajectory.start_time = time;
    trajectory.velocity = again ? before : body.motion.velocity;
    if (body.is_sphere && step_.falls[index_of(i)])
    {
      // What was held back at another touch pulls again: block() takes what leads into this one.
      trajectory.external = acceleration_on(step_.scene.gravity, step_.forces, index_of(i));
    }
    trajectory.reversed = trajectory.reversed || reverses(before, trajectory.velocity);
    if (response == ToiResponse::clamped)
    {
      trajectory.velocity.setZero();
      trajectory.external = {};
    }
    end(i, response);
    changed_.push_back(i);
  }

  /// Has a body that is hit go on from there, or only takes down its velocities.
  void resume_other(int i, const RigidBody& body, double time, ToiResponse response)
  {
    if (goes_on(step_, i))
    {
      return resume(i, body, time, is_clamped(i) ? ToiResponse::clamped : response);
    }
    const Vector3<double> gained =
        (step_.scene.step - time) * step_.trajectories[index_of(i)].external.acceleration;
    Motion<double>& end = ends_[index_of(i)].motion;
    end = {end.center, body.motion.velocity + gained, body.motion.angular_velocity};
  }

  /// Holds one of two bodies that go on from a touch back from the other.
  void block(
      int i, const RigidBody& body, const ToiEvent& event, const ToiManifold& manifold,
      ToiResponse response, double fraction)
  {
    remove_approach(step_, event, manifold, i, body, fraction);
    end(i, response);
  }

  /// Takes the bodies that go on from an event at a time [s], and updates their displacements.
  std::vector<int> take_changed(double time)
  {
    for (const int i : changed_)
    {
      update_displacement(step_, i, ends_[index_of(i)], time);
    }
    return std::exchange(changed_, {});
  }

private:
  void end(int i, ToiResponse response)
  {
    ends_[index_of(i)] =
        end_of_trajectory(step_.trajectories[index_of(i)], step_.scene.step, response);
  }

  StepTrajectories& step_;
  std::span<RigidBody> ends_;
  std::vector<int> event_counts_; // how often each body was the first at a touch
  std::vector<bool> is_blocked_;  // whether each body does not turn any more
  std::vector<int> changed_;
};
// [toi_substeps]

} // namespace cookbook
