#pragma once

/// \file
/// \brief Where a body is within a step, and how it goes on from a touch.

#include "06_world/islands/free_flight.hpp"
#include "06_world/sweeps/step_trajectories.hpp"

#include <algorithm>

namespace cookbook
{

// [trajectory_state]
/// A body that is not a ball in a pose of its course, spinning about its own axes as it would in
/// another pose: no other energy.
inline RigidBody with_orientation_of(RigidBody moving, const RigidBody& pose)
{
  const Vector3<double> spin = moving.axes.transpose() * moving.motion.angular_velocity;
  moving.orientation = pose.orientation;
  update_axes(moving);
  moving.motion.angular_velocity = moving.axes * spin;
  return moving;
}

/// A body at a time [s] of its course, as fast as it is there: `free` if that course is one of free
/// flight, with the velocities of its end otherwise.
inline RigidBody
state_at(const StepTrajectories& step, int i, double time, bool free, const RigidBody& end)
{
  const Trajectory& trajectory = step.trajectories[index_of(i)];
  const bool swept = is_swept_box(step, i);
  if (free)
  {
    RigidBody body = trajectory.start();
    integrate_free_flight(body, trajectory.external, time - trajectory.start_time);
    body.motion.center = trajectory.place_at(time);
    return swept ? with_orientation_of(body, trajectory.pose_at(time)) : body;
  }
  const RigidBody pose = trajectory.pose_at(time);
  RigidBody body = swept ? with_orientation_of(end, pose) : pose;
  body.motion.center = pose.motion.center;
  body.motion.velocity =
      end.motion.velocity - (step.scene.step - time) * trajectory.external.acceleration;
  if (!swept)
  {
    body.motion.angular_velocity = end.motion.angular_velocity;
  }
  return body;
}

/// How a body goes on from a touch.
enum class ToiResponse
{
  free,        ///< by itself
  supported,   ///< by itself, but not into what it leans on
  no_rotation, ///< the same without turning
  clamped      ///< it stays where it is for the rest of the step
};

/// A body at the end of a step [s] that follows its course by itself; the course learns how it
/// turns.
inline RigidBody end_of_trajectory(Trajectory& trajectory, double step, ToiResponse response)
{
  const double time = step - trajectory.start_time;
  const bool turns = response == ToiResponse::free || response == ToiResponse::supported;
  RigidBody end = trajectory.start();
  if (turns)
  {
    integrate_free_flight(end, trajectory.external, time);
  }
  else
  {
    end.motion.velocity += time * trajectory.external.acceleration;
  }
  trajectory.spin = turns ? spin_between(trajectory.from, end, time) : Vector3<double>::Zero();
  end.motion.center = trajectory.place_at(step);
  return end;
}

/// Takes down how far any point of a body goes from a time [s] on, if that is farther than before.
inline void update_displacement(StepTrajectories& step, int i, const RigidBody& end, double time)
{
  const Trajectory& trajectory = step.trajectories[index_of(i)];
  const double center = (end.motion.center - trajectory.from.motion.center).norm();
  double& displacement = step.displacements[index_of(i)];
  displacement =
      std::max(displacement, max_displacement(step, i, trajectory, center, step.scene.step - time));
}
// [trajectory_state]

} // namespace cookbook
