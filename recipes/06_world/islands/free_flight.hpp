#pragma once

/// \file
/// \brief Bodies of a world that nothing touches: gravity, forces and spin.

#include "06_world/contacts/moved_body.hpp"
#include "06_world/islands/past_body.hpp"

#include <algorithm>

namespace cookbook
{

// [fly]
/// Has what pulls a body alone move it for a time [s]: exactly along its parabola.
inline void fly(RigidBody& body, const Pull& by, double time)
{
  body.motion.center += time * (body.motion.velocity + time / 2 * by.acceleration);
  pull(body, by, time);
  spin(body, time);
  body.arms_at = body.orientation; // nothing pushes it at any
}

/// The angular momentum [kg m²/s], world, of a body that is turned like this, at a spin [rad/s].
inline Vector3<double> angular_momentum(
    const RigidBody& body, const Quaternion<double>& turned, const Vector3<double>& spin)
{
  return is_even(body) ? Vector3<double>(body.moments.x() * spin)
                       : turned * body.moments.cwiseProduct(turned.conjugate() * spin);
}

/// Whether anything but what pulls a body has changed how it moves, since it was at the start of a
/// step [s]: its momentum, not its spin, stays as it is.
inline bool was_pushed(const RigidBody& now, const PastBody& start, const Pull& by, double step)
{
  const auto differs = [](const Vector3<double>& a, const Vector3<double>& b)
  { return (a - b).norm() > 1e-9 * b.norm(); };
  const Motion<double> alone = after_pull(start.motion, by, step);
  return differs(now.motion.velocity, alone.velocity) ||
         differs(
             angular_momentum(now, now.orientation, now.motion.angular_velocity),
             angular_momentum(now, start.orientation, alone.angular_velocity));
}

/// The acceleration [m/s²] of a body that is pulled along others, by what its velocity changed in a
/// step [s]: a part of the pull, and what is held of that lies across it, but for a share by
/// friction. Zero where it does not slide like that.
inline Vector3<double> sliding_pull(
    const RigidBody& now, const PastBody& start, const Vector3<double>& pull, double step,
    double friction)
{
  const Vector3<double> changed = (now.motion.velocity - start.motion.velocity) / step;
  const double held = (pull - changed).dot(changed) / pull.squaredNorm();
  const bool slides =
      !is_fixed(now) && changed.norm() > 0.05 * pull.norm() && held > -1e-4 && held < friction;
  return slides ? changed : Vector3<double>(Vector3<double>::Zero());
}

/// Has a body that slides without friction end along its way where a parabola does, exactly, as in
/// free flight: a solver has left it ahead by a part of what that bends, and no more. `whole` is
/// all that pulls it [m/s²].
inline void slide(RigidBody& now, const PastBody& start, const Vector3<double>& whole, double step)
{
  const Vector3<double> pull = sliding_pull(now, start, whole, step, 1e-4);
  if (pull.isZero(0))
  {
    return;
  }
  const Vector3<double> mean = (start.motion.velocity + now.motion.velocity) / 2;
  const Vector3<double> aside = start.motion.center + step * mean - now.motion.center;
  const double share = -aside.dot(pull) / (step * step / 2 * pull.squaredNorm());
  if (share > 0 && share < 1.01)
  {
    now.motion.center += aside.dot(pull) / pull.squaredNorm() * pull;
  }
}

/// A step of a body that was not pushed.
struct Unpushed
{
  Vector3<double> bend;  ///< [m], by how much its parabola bends
  Vector3<double> aside; ///< [m], how far it is from the end of that
  double rounding;       ///< [m], of both
};

/// The step [s] of a body that was not pushed.
inline Unpushed
unpushed(const RigidBody& now, const PastBody& start, const Vector3<double>& pull, double step)
{
  const Vector3<double> none = Vector3<double>::Zero(), way = step * start.motion.velocity;
  if (is_fixed(now))
  {
    return {none, none, 0};
  }
  const Vector3<double> bend = step * step / 2 * pull;
  const Vector3<double> gone = now.motion.center - start.motion.center;
  const double rounding = 1e-9 * (way.norm() + bend.norm()) + 1e-14 * start.motion.center.norm();
  return {bend, gone - way - bend, rounding};
}

/// Whether two bodies that were not pushed have been moved apart, as out of an overlap.
///
/// A solver that moves bodies by the velocity at the end of a small step leaves each ahead of its
/// parabola, by up to what that bends: two that are pulled alike by the same.
inline bool were_parted(const Unpushed& a, const Unpushed& b)
{
  const Vector3<double> bend = b.bend - a.bend;
  Vector3<double> apart = b.aside - a.aside;
  if (const double squared = bend.squaredNorm(); squared > 0)
  {
    apart -= std::clamp(apart.dot(bend) / squared, 0.0, 1.0) * bend;
  }
  return apart.norm() > a.rounding + b.rounding;
}
// [fly]

} // namespace cookbook
