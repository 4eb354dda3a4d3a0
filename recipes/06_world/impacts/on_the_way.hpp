#pragma once

/// \file
/// \brief Where a body is on its way through a step, and how it goes on from a touch.

#include "06_world/islands/free_flight.hpp"
#include "06_world/sweeps/step_courses.hpp"

#include <algorithm>

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
    fly(body, course.pull, time - course.since);
    body.motion.center = course.place_at(time);
    return swept ? turned_like(body, course.pose_at(time)) : body;
  }
  const RigidBody pose = course.pose_at(time);
  RigidBody body = swept ? turned_like(end, pose) : pose;
  body.motion.center = pose.motion.center;
  body.motion.velocity = end.motion.velocity - (step.scene.step - time) * course.pull.acceleration;
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
    fly(end, course.pull, time);
  }
  else
  {
    end.motion.velocity += time * course.pull.acceleration;
  }
  course.spin = turns ? spin_between(course.from, end, time) : Vector3<double>::Zero();
  end.motion.center = course.place_at(step);
  return end;
}

/// Takes down how far any point of a body goes from a time [s] on, if that is farther than before.
inline void note_way(StepCourses& step, int i, const RigidBody& end, double time)
{
  const Course& course = step.courses[place_of(i)];
  const double center = (end.motion.center - course.from.motion.center).norm();
  double& way = step.ways[place_of(i)];
  way = std::max(way, farthest_way(step, i, course, center, step.scene.step - time));
}
// [on_the_way]

} // namespace cookbook
