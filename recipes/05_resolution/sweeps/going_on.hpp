#pragma once

/// \file
/// \brief How a body goes on from a touch, for the rest of a step.

#include "05_resolution/islands/free_flight.hpp"
#include "05_resolution/sweeps/touch_bounce.hpp"

#include <algorithm>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [on_the_way]
/// A body that is not a ball in a pose of its course, spinning about its own axes as it would in
/// another pose: no other energy.
inline RigidBody turned_like(RigidBody moving, const RigidBody& pose)
{
  const Vector3<double> spin = moving.axes.transpose() * moving.motion.angular_velocity;
  moving.orientation = pose.orientation;
  update_axes(moving);
  moving.motion.angular_velocity = moving.axes * spin;
  return moving;
}

/// A body at a time [s] of its course, as fast as it is there: `own` if that course is one of free
/// flight, with the velocities of its end otherwise.
inline RigidBody
on_the_way(const StepCourses& step, int i, double time, bool own, const RigidBody& end)
{
  const Course& course = step.courses[place_of(i)];
  const bool swept = is_swept_box(step, i);
  if (own)
  {
    RigidBody body = course.start();
    fly(body, course.acceleration, time - course.since);
    body.motion.center = course.place_at(time);
    return swept ? turned_like(body, course.pose_at(time)) : body;
  }
  const RigidBody pose = course.pose_at(time);
  RigidBody body = swept ? turned_like(end, pose) : pose;
  body.motion.center = pose.motion.center;
  body.motion.velocity = end.motion.velocity;
  if (!swept)
  {
    body.motion.angular_velocity = end.motion.angular_velocity;
  }
  return body;
}

/// How a body goes on from a touch.
enum class Onward
{
  free,  ///< by itself
  leans, ///< by itself, but not into what it leans on
  held,  ///< the same without turning
  frozen ///< it stays where it is for the rest of the step
};

/// A body at the end of a step [s] that follows its course by itself; the course learns how it
/// turns.
inline RigidBody gone_on(Course& course, double step, Onward how)
{
  const double time = step - course.since;
  const bool turns = how == Onward::free || how == Onward::leans;
  RigidBody end = course.start();
  if (turns)
  {
    fly(end, course.acceleration, time);
  }
  else
  {
    end.motion.velocity += time * course.acceleration;
  }
  course.spin = turns ? spin_between(*course.from, end, time) : Vector3<double>::Zero();
  end.motion.center = course.place_at(step);
  return end;
}

/// Takes down how far any point of a body goes from a time [s] on, if that is farther than before.
inline void note_way(StepCourses& step, int i, const RigidBody& end, double time)
{
  const Course& course = step.courses[place_of(i)];
  const double center = (end.motion.center - course.from->motion.center).norm();
  double& way = step.ways[place_of(i)];
  way = std::max(way, farthest_way(step, i, course, center, step.scene.step - time));
}
// [on_the_way]

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
  course.acceleration -= std::max(0.0, course.acceleration.dot(normal)) * normal;
}

/// Has bodies go on from touches, and knows who has.
class GoingOn
{
public:
  /// A step, and the bodies at its end.
  GoingOn(StepCourses& step, std::span<RigidBody> ends)
      : step_(step), ends_(ends), is_held_(ends.size(), false)
  {
  }

  /// Lets a body go on from where it is at a time [s] of the step.
  void go_on(int i, const RigidBody& body, double time, Onward how)
  {
    Course& course = step_.courses[place_of(i)];
    const Vector3<double> before = course.velocity_at(time);
    const bool again = how == Onward::held && is_held_[place_of(i)];
    is_held_[place_of(i)] = how == Onward::held;
    course.from = &turns_.emplace_back(body);
    course.since = time;
    course.velocity = again ? before : body.motion.velocity;
    course.angular_acceleration = body.angular_acceleration;
    course.tossed = course.tossed || turns_back(before, course.velocity);
    if (how == Onward::frozen)
    {
      course.velocity.setZero();
      course.acceleration.setZero();
    }
    end(i, how);
    changed_.push_back(i);
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
    RigidBody& end = ends_[place_of(i)];
    end = gone_on(step_.courses[place_of(i)], step_.scene.step, how);
    forget_forces(end);
  }

  StepCourses& step_;
  std::span<RigidBody> ends_;
  std::vector<bool> is_held_;   // whether each body does not turn any more
  std::deque<RigidBody> turns_; // bodies as they went on from a touch, where courses begin
  std::vector<int> changed_;
};
// [going_on]

} // namespace cookbook
