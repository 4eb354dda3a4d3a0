#pragma once

/// \file
/// \brief How a body goes on from a touch, for the rest of a step.

#include "06_world/impacts/on_the_way.hpp"
#include "06_world/impacts/touch_bounce.hpp"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [going_on]
/// Whether a body that goes one way is turned back by going another [m/s]: not by rounding.
inline bool turns_back(const Vector3<double>& before, const Vector3<double>& after)
{
  return -after.dot(before) > 0.02 * std::max(before.squaredNorm(), after.squaredNorm());
}

/// Takes out of the course of one of two bodies that touch a share of the speed at which it leads
/// into the other, and all of its acceleration that does: at the points where a box touches, at the
/// centre of a ball, or where there are none.
inline void hold_back(
    StepCourses& step, const CourseTouch& touch, const Met& met, int i, const RigidBody& body,
    double share)
{
  const bool is_first = i == touch.first;
  const Vector3<double> normal = is_first ? touch.normal : -touch.normal;
  const Course& other = step.courses[place_of(is_first ? touch.other : touch.first)];
  Course& course = step.courses[place_of(i)];
  double inwards = 0;
  const auto look = [&](const Vector3<double>& place)
  {
    const Vector3<double> closing =
        course.velocity_of(place, touch.time) - other.velocity_of(place, touch.time);
    inwards = std::max(inwards, closing.dot(normal));
  };
  if (body.round || !met)
  {
    look(body.motion.center);
  }
  else
  {
    for (const ContactPoint<double>& point : met->points)
    {
      look(point.position);
    }
  }
  course.velocity -= share * inwards * normal;
  Vector3<double>& pull = course.pull.acceleration;
  pull -= std::max(0.0, pull.dot(normal)) * normal;
}

/// The most touches of a body in a step; from then on it only stops, and a box does not turn; after
/// as many more it stays where it is.
inline constexpr int most_touches_a_step = 64;

/// Has bodies go on from touches, and knows who has, and how often each was the first at a touch.
class GoingOn
{
public:
  /// A step, and the bodies at its end.
  GoingOn(StepCourses& step, std::span<RigidBody> ends)
      : step_(step), ends_(ends), touched_(ends.size(), 0), is_held_(ends.size(), false)
  {
  }

  void count_touch(int i) { ++touched_[place_of(i)]; } ///< of the body that goes first
  /// Whether a body has touched so often that it only stops.
  bool is_tired(int i) const { return touched_[place_of(i)] > most_touches_a_step; }
  /// Whether it has so often that it stays where it is.
  bool is_frozen(int i) const { return touched_[place_of(i)] > 2 * most_touches_a_step; }

  /// Lets a body go on from where it is at a time [s] of the step.
  void go_on(int i, const RigidBody& body, double time, Onward how)
  {
    Course& course = step_.courses[place_of(i)];
    const Vector3<double> before = course.velocity_at(time);
    const bool again = how == Onward::held && is_held_[place_of(i)];
    is_held_[place_of(i)] = how == Onward::held;
    course.from = past_of(body);
    course.since = time;
    course.velocity = again ? before : body.motion.velocity;
    if (body.round && step_.falls[place_of(i)])
    {
      // What was held back at another touch pulls again: hold() takes what leads into this one.
      course.pull = pull_on(step_.scene.gravity, step_.forces, place_of(i));
    }
    course.tossed = course.tossed || turns_back(before, course.velocity);
    if (how == Onward::frozen)
    {
      course.velocity.setZero();
      course.pull = {};
    }
    end(i, how);
    changed_.push_back(i);
  }

  /// Has a body that is hit go on from there, or only takes down its velocities.
  void pass_on(int i, const RigidBody& body, double time, Onward how)
  {
    if (goes_on(step_, i))
    {
      return go_on(i, body, time, is_frozen(i) ? Onward::frozen : how);
    }
    const Vector3<double> gained =
        (step_.scene.step - time) * step_.courses[place_of(i)].pull.acceleration;
    Motion<double>& end = ends_[place_of(i)].motion;
    end = {end.center, body.motion.velocity + gained, body.motion.angular_velocity};
  }

  /// Holds one of two bodies that go on from a touch back from the other.
  void hold(
      int i, const RigidBody& body, const CourseTouch& touch, const Met& met, Onward how,
      double share)
  {
    hold_back(step_, touch, met, i, body, share);
    end(i, how);
  }

  /// Who goes on from a touch at a time [s], the ways of all taken down; then nobody does any more.
  std::vector<int> take_changed(double time)
  {
    for (const int i : changed_)
    {
      note_way(step_, i, ends_[place_of(i)], time);
    }
    return std::exchange(changed_, {});
  }

private:
  void end(int i, Onward how)
  {
    ends_[place_of(i)] = gone_on(step_.courses[place_of(i)], step_.scene.step, how);
  }

  StepCourses& step_;
  std::span<RigidBody> ends_;
  std::vector<int> touched_;  // how often each body was the first at a touch
  std::vector<bool> is_held_; // whether each body does not turn any more
  std::vector<int> changed_;
};
// [going_on]

} // namespace cookbook
