#pragma once

/// \file
/// \brief How a body of a world goes through a step.

#include "01_math/turning/turn_between.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/islands/free_flight.hpp"
#include "06_world/islands/previous_state.hpp"

#include <span>

namespace cookbook
{

// [predictions]
/// What is known of a body's step if nothing pushes it, before any other body is looked at.
struct Prediction
{
  Vector3<double> displacement; ///< [m], of its centre, where nothing touches it
  double rotation;              ///< [m], how far it takes any of its points that it turns
  double allowed_penetration;   ///< [m], how deep another may get into it unforeseen

  /// How far [m] any of its points goes.
  double max_displacement() const { return displacement.norm() + rotation; }
};

/// A step of a world as it is before it is taken.
struct PredictedStep
{
  const Scene& scene;                ///< with the bodies' shapes; where they are, `bodies` says
  std::span<const RigidBody> bodies; ///< as they are
  std::span<const ExternalAcceleration> forces; ///< on them, force_on()
  std::span<Prediction> prediction; ///< what is known of each, once predict() has said it
};

/// Whether forces pull either of two bodies.
inline bool are_forced(const PredictedStep& step, int i, int j)
{
  const auto is_forced = [&](int one)
  {
    return !is_fixed(step.bodies[index_of(one)]) &&
           force_on(step.forces, index_of(one)).acceleration.any();
  };
  return !step.forces.empty() && (is_forced(i) || is_forced(j));
}
// [predictions]

// [trajectory]
/// A body slides along others with at least this fraction of what pulls it, or hardly at all; less
/// friction than this leaves its path a parabola.
inline constexpr double sliding_fraction = 0.05;
/// A slide gains this fraction of the pull across it by what a solver leaves undone.
inline constexpr double sliding_rounding = 1e-4;

/// The acceleration [m/s²] of a body that is pulled along others, by what its velocity changed in a
/// step [s]: a part of the pull, and what is held of that lies across it, but for a fraction by
/// friction. Zero where it does not slide like that.
inline Vector3<double> sliding_acceleration(
    const RigidBody& now, const PreviousState& start, const Vector3<double>& pull, double step,
    double friction)
{
  const Vector3<double> changed = (now.motion.velocity - start.motion.velocity) / step;
  const double constrained = (pull - changed).dot(changed) / pull.squaredNorm();
  const bool slides = !is_fixed(now) && changed.norm() > sliding_fraction * pull.norm() &&
                      constrained > -sliding_rounding && constrained < friction;
  return slides ? changed : Vector3<double>(Vector3<double>::Zero());
}

/// A body's way through a step, or through what is left of it: the centre along a parabola, or
/// straight where nothing of its pull is left; the body turns steadily.
struct Trajectory
{
  const RigidBody* of;           ///< the body, kept elsewhere: for what no step changes
  PreviousState from;            ///< how it is as this course begins
  double start_time;             ///< [s], of the step, when it begins
  Vector3<double> velocity;      ///< [m/s], at which the centre sets out
  ExternalAcceleration external; ///< what bends the way of the centre, and speeds the spin up
  Vector3<double> spin;          ///< [rad/s], world; zero for a ball, whose turning changes nothing
  bool reversed = false;         ///< whether a touch has turned it back in this step

  /// The body as this course begins.
  RigidBody start() const { return with_state(*of, from); }
  /// The velocity [m/s] of the centre at a time [s] of the step.
  Vector3<double> velocity_at(double time) const
  {
    return velocity + (time - start_time) * external.acceleration;
  }
  /// The place [m] of the centre at that time.
  Vector3<double> place_at(double time) const
  {
    const double on = time - start_time;
    return from.motion.center + on * (velocity + on / 2 * external.acceleration);
  }
  /// The velocity [m/s] at that time of what the body carries along at a place [m].
  Vector3<double> velocity_of(const Vector3<double>& place, double time) const
  {
    return velocity_at(time) + spin.cross(place - place_at(time));
  }
  /// The pose of the body at that time; its motion is still that of the start.
  RigidBody pose_at(double time) const
  {
    PreviousState then = from;
    then.motion.center = place_at(time);
    if (!spin.isZero(0))
    {
      then.orientation = turned_by(from, (time - start_time) * spin);
    }
    return with_state(*of, then);
  }
};

/// The steady spin [rad/s] that turns a body from one pose to another in a time [s].
inline Vector3<double> spin_between(const PreviousState& from, const RigidBody& to, double time)
{
  if (to.is_sphere || !(time > 0))
  {
    return Vector3<double>::Zero();
  }
  return turn_between<double>(from.orientation, to.orientation) / time;
}

/// The course of a body that others have pushed, from one pose to another in a step [s].
inline Trajectory pushed_trajectory(
    const PreviousState& from, const RigidBody& to, double step, const ExternalAcceleration& by)
{
  const ExternalAcceleration slide{
      sliding_acceleration(to, from, by.acceleration, step, sliding_fraction)};
  const Vector3<double> mean = (to.motion.center - from.motion.center) / step;
  const Vector3<double> velocity = mean - step / 2 * slide.acceleration;
  return {&to, from, 0, velocity, slide, spin_between(from, to, step)};
}

/// The course of a body that nothing touches in a step [s], to a pose at its end.
inline Trajectory falling_trajectory(
    const PreviousState& from, const RigidBody& to, double step, const ExternalAcceleration& by)
{
  return {&to, from, 0, from.motion.velocity, by, spin_between(from, to, step)};
}
// [trajectory]

} // namespace cookbook
