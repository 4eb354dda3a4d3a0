#pragma once

/// \file
/// \brief How much is missing in an island, and how little is little enough.

#include "05_resolution/direct_solver/direct_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cookbook
{

/// The largest impulse [N s] of an island.
inline double largest_impulse(const DirectSystem& system)
{
  double most = 0;
  for (const DirectPoint& point : system.points)
  {
    most = std::max(most, point.impulse);
  }
  return most;
}

// [direct_small]
/// How much is missing [N s], as a root of a sum of squares; turns count by the radius of gyration.
inline double size_of_missing(const DirectSystem& system)
{
  double sum = 0;
  for (std::size_t i = 0; i < system.missing.size(); ++i)
  {
    const double squared_radius = system.bodies[i].inertia.trace() / system.bodies[i].mass;
    sum += system.missing[i].head<3>().squaredNorm() +
           system.missing[i].tail<3>().squaredNorm() / squared_radius;
  }
  return std::sqrt(sum);
}

/// What rounding of the velocities alone leaves missing [N s], at the stiffest contact.
inline double rounding_of(const DirectSystem& system)
{
  double fastest = 0, stiffest = 0;
  for (const Vector6& velocity : system.velocities)
  {
    fastest = std::max(fastest, velocity.head<3>().cwiseAbs().maxCoeff());
  }
  for (const DirectContact& contact : system.contacts)
  {
    stiffest = std::max(stiffest, 1 / contact.softness.push);
  }
  return 8 * std::numeric_limits<double>::epsilon() * fastest * stiffest;
}
// [direct_small]

} // namespace cookbook
