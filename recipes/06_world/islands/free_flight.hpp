#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity, forces and spin.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/islands/previous_state.hpp"

#include <algorithm>

namespace cookbook
{

// [free_flight]
/// Has what pulls a body alone move it for a time [s]: exactly along its parabola.
inline void integrate_free_flight(RigidBody& body, const ExternalAcceleration& by, double time)
{
  body.motion.center += time * (body.motion.velocity + time / 2 * by.acceleration);
  apply_forces(body, by, time);
  rotate_freely(body, time);
  body.lagged_orientation = body.orientation; // nothing pushes it at any
}

/// The angular momentum [kg m²/s], world, of a body that is turned like this, at a spin [rad/s].
inline Vector3<double> angular_momentum(
    const RigidBody& body, const Quaternion<double>& turned, const Vector3<double>& spin)
{
  return has_equal_moments(body) ? Vector3<double>(body.moments.x() * spin)
                                 : turned * body.moments.cwiseProduct(turned.conjugate() * spin);
}

/// Whether anything but what pulls a body has changed how it moves, since it was at the start of a
/// step [s]: its momentum, not its spin, stays as it is.
inline bool was_pushed(
    const RigidBody& now, const PreviousState& start, const ExternalAcceleration& by, double step)
{
  const auto differs = [](const Vector3<double>& a, const Vector3<double>& b)
  { return (a - b).norm() > 1e-9 * b.norm(); };
  const Motion<double> alone = accelerated(start.motion, by, step);
  return differs(now.motion.velocity, alone.velocity) ||
         differs(
             angular_momentum(now, now.orientation, now.motion.angular_velocity),
             angular_momentum(now, start.orientation, alone.angular_velocity));
}

/// The acceleration [m/s²] of a body that is pulled along others, by what its velocity changed in a
/// step [s]: a part of the pull, and what is held of that lies across it, but for a share by
/// friction. Zero where it does not slide like that.
inline Vector3<double> sliding_acceleration(
    const RigidBody& now, const PreviousState& start, const Vector3<double>& pull, double step,
    double friction)
{
  const Vector3<double> changed = (now.motion.velocity - start.motion.velocity) / step;
  const double constrained = (pull - changed).dot(changed) / pull.squaredNorm();
  const bool slides = !is_fixed(now) && changed.norm() > 0.05 * pull.norm() &&
                      constrained > -1e-4 && constrained < friction;
  return slides ? changed : Vector3<double>(Vector3<double>::Zero());
}

/// Has a body that slides without friction end along its way where a parabola does, exactly, as in
/// free flight: a solver has left it ahead by a part of what that bends, and no more. `whole` is
/// all that pulls it [m/s²].
inline void correct_sliding(
    RigidBody& now, const PreviousState& start, const Vector3<double>& whole, double step)
{
  const Vector3<double> pull = sliding_acceleration(now, start, whole, step, 1e-4);
  if (pull.isZero(0))
  {
    return;
  }
  const Vector3<double> mean = (start.motion.velocity + now.motion.velocity) / 2;
  const Vector3<double> deviation = start.motion.center + step * mean - now.motion.center;
  const double fraction = -deviation.dot(pull) / (step * step / 2 * pull.squaredNorm());
  if (fraction > 0 && fraction < 1.01)
  {
    now.motion.center += deviation.dot(pull) / pull.squaredNorm() * pull;
  }
}

/// A step of a body that was not pushed.
struct FreeStep
{
  Vector3<double> deflection; ///< [m], by how much its parabola bends
  Vector3<double> deviation;  ///< [m], how far it is from the end of that
  double rounding;            ///< [m], of both
};

/// The step [s] of a body that was not pushed.
inline FreeStep free_step(
    const RigidBody& now, const PreviousState& start, const Vector3<double>& pull, double step)
{
  const Vector3<double> none = Vector3<double>::Zero(), displacement = step * start.motion.velocity;
  if (is_fixed(now))
  {
    return {none, none, 0};
  }
  const Vector3<double> deflection = step * step / 2 * pull;
  const Vector3<double> moved = now.motion.center - start.motion.center;
  const double rounding =
      1e-9 * (displacement.norm() + deflection.norm()) + 1e-14 * start.motion.center.norm();
  return {deflection, moved - displacement - deflection, rounding};
}

/// Whether two bodies that were not pushed have been moved apart, as out of an overlap.
///
/// A solver that moves bodies by the velocity at the end of a small step leaves each ahead of its
/// parabola, by up to what that bends: two that are pulled alike by the same.
inline bool were_separated(const FreeStep& a, const FreeStep& b)
{
  const Vector3<double> deflection = b.deflection - a.deflection;
  Vector3<double> separation = b.deviation - a.deviation;
  if (const double squared = deflection.squaredNorm(); squared > 0)
  {
    separation -= std::clamp(separation.dot(deflection) / squared, 0.0, 1.0) * deflection;
  }
  return separation.norm() > a.rounding + b.rounding;
}
// [free_flight]

} // namespace cookbook
