#pragma once

/// \file
/// \brief How a body of a world goes through a step.

#include "01_math/turning/turn_between.hpp"
#include "06_world/islands/free_flight.hpp"

#include <span>

namespace cookbook
{

// [ahead]
/// What is known of a body's step if nothing pushes it, before any other body is looked at.
struct Ahead
{
  Vector3<double> way; ///< [m], of its centre, where nothing touches it
  double turn;         ///< [m], how far it takes any of its points that it turns
  double harmless;     ///< [m], how deep another may get into it unforeseen

  /// How far [m] any of its points goes.
  double farthest() const { return way.norm() + turn; }
};

/// A step of a world as it is before it is taken.
struct StepAhead
{
  const Scene& scene;                ///< with the bodies' shapes; where they are, `bodies` says
  std::span<const RigidBody> bodies; ///< as they are
  std::span<const Pull> forces;      ///< on them, force_on()
  std::span<Ahead> ahead;            ///< what is known of each, once ahead_of() has said it
};

/// Whether forces pull either of two bodies.
inline bool are_forced(const StepAhead& step, int i, int j)
{
  const auto is_forced = [&](int one)
  {
    return !is_fixed(step.bodies[place_of(one)]) &&
           force_on(step.forces, place_of(one)).acceleration.any();
  };
  return !step.forces.empty() && (is_forced(i) || is_forced(j));
}
// [ahead]

// [course]
/// A body's way through a step, or through what is left of it: the centre along a parabola, or
/// straight where nothing of its pull is left; the body turns steadily.
struct Course
{
  const RigidBody* of;      ///< the body, kept elsewhere: for what no step changes
  PastBody from;            ///< how it is as this course begins
  double since;             ///< [s], of the step, when it begins
  Vector3<double> velocity; ///< [m/s], at which the centre sets out
  Pull pull;                ///< what bends the way of the centre, and speeds the spin up
  Vector3<double> spin;     ///< [rad/s], world; zero for a ball, whose turning changes nothing
  bool tossed = false;      ///< whether a touch has turned it back in this step

  /// The body as this course begins.
  RigidBody start() const { return as_it_was(*of, from); }
  /// The velocity [m/s] of the centre at a time [s] of the step.
  Vector3<double> velocity_at(double time) const
  {
    return velocity + (time - since) * pull.acceleration;
  }
  /// The place [m] of the centre at that time.
  Vector3<double> place_at(double time) const
  {
    const double on = time - since;
    return from.motion.center + on * (velocity + on / 2 * pull.acceleration);
  }
  /// The velocity [m/s] at that time of what the body carries along at a place [m].
  Vector3<double> velocity_of(const Vector3<double>& place, double time) const
  {
    return velocity_at(time) + spin.cross(place - place_at(time));
  }
  /// The pose of the body at that time; its motion is still that of the start.
  RigidBody pose_at(double time) const
  {
    PastBody then = from;
    then.motion.center = place_at(time);
    if (!spin.isZero(0))
    {
      then.orientation = turned_by(from, (time - since) * spin);
    }
    return as_it_was(*of, then);
  }
};

/// The steady spin [rad/s] that turns a body from one pose to another in a time [s].
inline Vector3<double> spin_between(const PastBody& from, const RigidBody& to, double time)
{
  if (to.round || !(time > 0))
  {
    return Vector3<double>::Zero();
  }
  return turn_between<double>(from.orientation, to.orientation) / time;
}

/// The course of a body that others have pushed, from one pose to another in a step [s].
inline Course pushed_course(const PastBody& from, const RigidBody& to, double step, const Pull& by)
{
  const Pull slide{sliding_pull(to, from, by.acceleration, step, 0.05)};
  const Vector3<double> mean = (to.motion.center - from.motion.center) / step;
  const Vector3<double> velocity = mean - step / 2 * slide.acceleration;
  return {&to, from, 0, velocity, slide, spin_between(from, to, step)};
}

/// The course of a body that nothing touches in a step [s], to a pose at its end.
inline Course falling_course(const PastBody& from, const RigidBody& to, double step, const Pull& by)
{
  return {&to, from, 0, from.motion.velocity, by, spin_between(from, to, step)};
}
// [course]

} // namespace cookbook
