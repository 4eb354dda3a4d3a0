#pragma once

/// \file
/// \brief What an impact does to the energy of bodies, and what part of it a game brings in.

#include "06_world/islands/island_points.hpp"

#include <cmath>
#include <span>

namespace cookbook
{

// [impact_energy]
/// The kinetic energy [J] of bodies together.
inline double kinetic_energy_of(std::span<RigidBody* const> bodies)
{
  double sum = 0;
  for (const RigidBody* const body : bodies)
  {
    sum += kinetic_energy(*body);
  }
  return sum;
}

/// Energy that grows by less than this fraction has not: passes add up rounding of 2.2e-16.
inline constexpr double energy_rounding = 1e-9;

/// Whether an energy [J] has grown by more than the work [J] that was done.
inline bool has_grown(double before, double after, double work)
{
  return !(after - before - work <= energy_rounding * (before + std::abs(work)));
}

/// The work [J] that a kinematic body does by the impulse at a point, J · v; zero without one.
inline double work_of_driven(const IslandPoint& point)
{
  const Vector3<double> impulse = contact_impulse(point);
  const auto along = [&](const RigidBody& body, const Vector3<double>& arm)
  {
    const auto& [center, velocity, spin] = body.motion;
    return is_driven(body) ? impulse.dot(velocity + spin.cross(arm)) : 0.0;
  };
  return along(*point.a, point.arms.a) - along(*point.b, point.arms.b);
}
// [impact_energy]

} // namespace cookbook
