#pragma once

/// \file
/// \brief How far a body goes in a substep: along a parabola where nothing keeps it off.

#include "06_world/islands/island_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

// [displacement]
/// The relative rounding [1] of a velocity that a solver in double has changed a few times.
inline constexpr double velocity_rounding = 8 * std::numeric_limits<double>::epsilon();

/// How much [m/s] of what pulls a body in a substep changes its velocity evenly: all of it where
/// nothing holds the body, and what lies across the `held` that does, as a smooth wall along which
/// it falls. Nothing where that does more or less than hold: it slows the body or speeds it up.
///
/// `rounding` [m/s] is that of a velocity. Within it a body that rests, and sways by a little
/// across what pulls it, is held across, too: by up to the root of the rounding times the pull. It
/// is told from one that slides by twice as much.
inline Vector3<double>
even_change(const Vector3<double>& pull, const Vector3<double>& held, double rounding)
{
  const double size = held.norm();
  if (size <= std::min(rounding, pull.norm() / 2))
  {
    return pull;
  }
  const Vector3<double> change = pull + held;
  const double most = rounding * (size + change.norm());
  const bool slides = std::abs(held.dot(change)) <= most && change.squaredNorm() > 4 * most;
  return slides ? Vector3<double>(pull - pull.dot(held) / (size * size) * held)
                : Vector3<double>(0, 0, 0);
}

/// How far [m] a body goes in a substep [s]: by the velocity of its end, by which gaps close, but
/// along a parabola as far as its velocity changes evenly.
inline Vector3<double> displacement(
    IslandView world, std::size_t i, const FreeMotion& free, double substep, double rounding)
{
  const Vector3<double>& velocity = world.bodies[i].motion.velocity;
  const Vector3<double> pull = substep * acceleration_on(world, static_cast<int>(i)).acceleration;
  const Vector3<double> even =
      even_change(pull, velocity - free.velocity, rounding * (velocity.norm() + pull.norm()));
  return substep * (velocity - even / 2);
}
// [displacement]

} // namespace cookbook
