#pragma once

/// \file
/// \brief What pulls the bodies of a world in a step: gravity, and the forces of a game.

#include "03_sphere_manifolds/collision/motion.hpp"
#include "05_resolution/restitution/restitution.hpp"
#include "common/math/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [external_acceleration]
/// What pulls a body that is not fixed, in a step.
struct ExternalAcceleration
{
  Vector3<double> acceleration = Vector3<double>::Zero();         ///< [m/s²], world
  Vector3<double> angular_acceleration = Vector3<double>::Zero(); ///< [rad/s²], world
};

/// What the forces of a step do to the body at a place; nothing behind the end of their list.
inline ExternalAcceleration
force_on(std::span<const ExternalAcceleration> forces, std::size_t place)
{
  return place < forces.size() ? forces[place] : ExternalAcceleration{};
}

/// Forces last as long as this, also where a step throws.
struct ClearForces
{
  std::vector<ExternalAcceleration>& forces;

  ~ClearForces() { forces.clear(); }
};

/// What gravity [m/s²] and the forces of a step do together to the body at a place.
inline ExternalAcceleration acceleration_on(
    const Vector3<double>& gravity, std::span<const ExternalAcceleration> forces, std::size_t place)
{
  ExternalAcceleration pull = force_on(forces, place);
  pull.acceleration += gravity;
  return pull;
}

/// The fastest approach [m/s] that is a rest in a step [s], where what pulls parts two bodies at
/// this acceleration [m/s²]: by gravity, or by what presses them, if that is more.
inline double
rest_threshold(const Vector3<double>& gravity, double separating_acceleration, double step)
{
  return restitution_threshold(std::max(gravity.norm(), -separating_acceleration), step);
}

/// How a body moves once something has pulled it for a time [s], where it is.
inline Motion<double>
accelerated(const Motion<double>& motion, const ExternalAcceleration& by, double time)
{
  const auto& [center, velocity, spin] = motion;
  return {center, velocity + time * by.acceleration, spin + time * by.angular_acceleration};
}

/// The centripetal acceleration [m/s²] of a body's point at an arm [m], as the body spins [rad/s].
inline Vector3<double>
centripetal_acceleration(const Vector3<double>& spin, const Vector3<double>& arm)
{
  return spin.cross(spin.cross(arm));
}
// [external_acceleration]

} // namespace cookbook
