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

// [line_search]
/// How fast the energy falls along a change of velocities: the residual along it.
inline double residual_along(const DirectSystem& system, const std::vector<Vector6>& change)
{
  double sum = 0;
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    sum += system.residual[i].dot(change[i]);
  }
  return sum;
}

/// True if the states of all points and rows are as before, and no point slips.
inline bool has_same_active_set(const DirectSystem& system)
{
  return std::equal(
             system.points.begin(), system.points.end(), system.states_before.begin(),
             [](const DirectPoint& one, const ContactState& then)
             { return one == then && one.friction_state != FrictionState::slip; }) &&
         std::equal(
             system.rows.begin(), system.rows.end(), system.rows_before.begin(),
             [](const DirectRow& row, int then) { return row.at == then; });
}

/// How far a change of velocities was followed.
struct LineSearch
{
  double fraction; ///< [1], of the way
  bool exact;      ///< all of it, and with the same active set
  bool stuck;      ///< nowhere did the energy stop falling, as at a point without a bound
};

/// Moves the velocities by a fraction of a change, and finds the residual there.
inline void go_along(DirectSystem& system, const std::vector<Vector6>& change, double fraction)
{
  for (std::size_t i = 0; i < change.size(); ++i)
  {
    system.velocities[i] = system.velocities_before[i] + fraction * change[i];
  }
  find_residual(system);
}

/// Gives rows their bounds back, and finds the residual with them; whether any was without.
inline bool bound_rows(DirectSystem& system)
{
  const bool any = bound_all(system.rows);
  if (any)
  {
    find_residual(system);
  }
  return any;
}

/// Leaves the bounds out of the next change of rows that go from one to the other between two
/// fractions of this one: a motor comes to its speed in between.
inline void
free_crossing(DirectSystem& system, const std::vector<Vector6>& change, double low, double high)
{
  if (system.rows.empty())
  {
    return;
  }
  bound_all(system.rows);
  go_along(system, change, high);
  std::transform(
      system.rows.begin(), system.rows.end(), system.rows_before.begin(),
      [](const DirectRow& row) { return row.at; });
  go_along(system, change, low);
  for (std::size_t i = 0; i < system.rows.size(); ++i)
  {
    system.rows[i].unbounded = system.rows[i].at * system.rows_before[i] < 0;
  }
  find_residual(system);
}

/// Goes along a change of velocities to where the energy stops falling.
inline LineSearch line_search(DirectSystem& system, const std::vector<Vector6>& change)
{
  system.states_before.assign(system.points.begin(), system.points.end());
  system.rows_before.clear();
  for (const DirectRow& row : system.rows)
  {
    system.rows_before.push_back(row.at);
  }
  system.velocities_before = system.velocities;
  const double slope = residual_along(system, change);
  double low = 0, high = 1, at_low = slope, at_high = 0, fraction = 1;
  for (int iteration = 0; iteration < 20; ++iteration)
  {
    go_along(system, change, fraction);
    if (fraction == 1 && has_same_active_set(system))
    {
      return {fraction, true, false};
    }
    const double now = residual_along(system, change);
    if (std::abs(now) <= 0.2 * std::abs(slope) || (fraction == 1 && now > 0))
    {
      return {fraction, false, false};
    }
    (now > 0 ? low : high) = fraction;
    (now > 0 ? at_low : at_high) = now;
    const double secant = at_low / (at_low - at_high);
    fraction = low + (high - low) * (iteration % 3 == 2 ? 0.5 : std::clamp(secant, 0.01, 0.99));
  }
  free_crossing(system, change, low, high);
  return {fraction, false, true};
}
// [line_search]

} // namespace cookbook
