#pragma once

/// \file
/// \brief How far to go along a change of velocities that Newton's method asks for.

#include "06_world/direct_solver/direct_residual.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace cookbook
{

// [direct_advance]
/// How fast the energy falls along a change of velocities.
inline double missing_along(const DirectSystem& system, const std::vector<Vector6>& change)
{
  double sum = 0;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    sum += system.missing[i].dot(change[i]);
  }
  return sum;
}

/// True if all points push in the way that they did before, and none slips.
inline bool
push_as_before(const std::vector<DirectPoint>& now, const std::vector<PushingWay>& before)
{
  return std::equal(
      now.begin(), now.end(), before.begin(),
      [](const DirectPoint& one, const PushingWay& then)
      { return one == then && one.grip != Grip::slip; });
}

/// How far a change of velocities was followed.
struct Advance
{
  double part; ///< [1], of the way
  bool exact;  ///< all of it, and no point pushes in another way than before
  bool stuck;  ///< nowhere did the energy stop falling, as at a point without a bound
};

/// Goes along a change of velocities to where the energy stops falling.
inline Advance advance(DirectSystem& system, const std::vector<Vector6>& change)
{
  system.ways_before.assign(system.points.begin(), system.points.end());
  system.velocities_before = system.velocities;
  const double steep = missing_along(system, change);
  double low = 0, high = 1, at_low = steep, at_high = 0, part = 1;
  for (int tries = 0; tries < 20; ++tries)
  {
    for (std::size_t i = 0; i < change.size(); ++i)
    {
      system.velocities[i] = system.velocities_before[i] + part * change[i];
    }
    find_missing(system);
    if (part == 1 && push_as_before(system.points, system.ways_before))
    {
      return {part, true, false};
    }
    const double now = missing_along(system, change);
    if (std::abs(now) <= 0.2 * std::abs(steep) || (part == 1 && now > 0))
    {
      return {part, false, false};
    }
    (now > 0 ? low : high) = part;
    (now > 0 ? at_low : at_high) = now;
    const double secant = at_low / (at_low - at_high);
    part = low + (high - low) * (tries % 3 == 2 ? 0.5 : std::clamp(secant, 0.01, 0.99));
  }
  return {part, false, true};
}
// [direct_advance]

} // namespace cookbook
