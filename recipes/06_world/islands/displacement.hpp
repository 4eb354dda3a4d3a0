#pragma once

/// \file
/// \brief How far a body goes in a step: along a parabola where nothing keeps it off.

#include "06_world/islands/island_points.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [displacement]
/// The relative rounding [1] of a velocity that a solver in double has changed a few times.
inline constexpr double velocity_rounding = 8 * std::numeric_limits<double>::epsilon();

/// How much work in a step, relative to the square of the pull, what holds a body may do [1].
/// Springs that still settle do some, and friction does as much as its coefficient.
inline constexpr double holding_work = 1e-3;

/// The change [m/s] of a body's velocity in a step as far as it is even, so that the body goes by
/// the mean velocity: all of it where what `held` the body [m/s] stood across its change, as a
/// smooth wall along which it falls. None where that slowed the body or sped it up.
///
/// `rounding` [m/s] is that of a velocity, `work` [1] what may be done, as holding_work. A body
/// that rests sways across what pulls it by up to the root of the work that is let through: it is
/// told from one that slides by twice as much.
inline Vector3<double>
even_change(const Vector3<double>& pull, const Vector3<double>& held, double rounding, double work)
{
  const Vector3<double> change = pull + held;
  const auto slides = [&](double most)
  { return std::abs(held.dot(change)) <= most && change.squaredNorm() > 4 * most; };
  const bool even =
      slides(rounding * (held.norm() + change.norm())) || slides(work * pull.squaredNorm());
  return even ? change : Vector3<double>(0, 0, 0);
}

/// The speed [m/s] that a change of its spin gives a body's points at its radius of gyration.
inline double gyration_speed(const RigidBody& body, const Vector3<double>& change_of_spin)
{
  return std::sqrt(body.moments.maxCoeff() * body.inverse_mass) * change_of_spin.norm();
}

/// By how much [m] the velocities at the ends of substeps [s] have moved a body further in a step
/// [s] than its parabola. What has also been turned has gone round by the spins at their ends: its
/// points would part from what holds them. `work` [1] is what may be done on it, as holding_work.
inline Vector3<double> overshoot(
    IslandView world, std::size_t i, const StepStart& start, double step, double substep,
    double rounding, double work)
{
  const RigidBody& body = world.bodies[i];
  const Vector3<double>& velocity = body.motion.velocity;
  const Vector3<double> pull = step * acceleration_on(world, static_cast<int>(i)).acceleration;
  if (!start.pushed)
  {
    return substep / 2 * pull;
  }
  const Vector3<double> held = velocity - start.velocity - pull;
  const double lost = rounding * (velocity.norm() + pull.norm());
  const double turned = gyration_speed(body, body.motion.angular_velocity - start.angular_velocity);
  return turned > holding_work * pull.norm() + lost
             ? Vector3<double>(0, 0, 0)
             : Vector3<double>(substep / 2 * even_change(pull, held, lost, work));
}
// [displacement]

} // namespace cookbook
