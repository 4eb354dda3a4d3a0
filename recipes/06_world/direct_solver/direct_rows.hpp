#pragma once

/// \file
/// \brief The equations of joints in the direct solver: each a stiff spring.

#include "06_world/direct_solver/block_cholesky.hpp"
#include "06_world/direct_solver/direct_points.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace cookbook
{

// [direct_rows]
/// A row of a joint; its bodies are numbered as those of a contact. Its impulse is
/// −(stiffness · speed + offset), within its bounds.
struct DirectRow
{
  int a, b;                 ///< the two bodies
  Vector6 on_a, on_b;       ///< J
  const ConstraintPair* of; ///< where it comes from
  double stiffness = 0;     ///< [kg], an impulse for a speed
  double offset = 0;        ///< [N s], to close its error, and for bodies not of the island
  double lower = 0;         ///< [N s], bounds
  double upper = 0;
  double impulse = 0;     ///< [N s]
  bool bends = false;     ///< whether its error bends off what J says as bodies turn
  double error = 0;       ///< [m, rad], before the step
  double bent = 0;        ///< [m, rad], what the offset takes of what J does not predict
  double bend = 0;        ///< [m, rad], what it does not take yet
  int at = 0;             ///< −1 or 1: at its lower or upper bound; 0: within them
  bool unbounded = false; ///< whether its bounds are left out in the next change
};

/// The stiffness [kg] of a row, an impulse for a speed, of bodies that give way to it by
/// `inverse_mass`: of a spring what its step asks for, of other rows the stiffest there is.
inline double
stiffness_of(const ConstraintRow& row, double inverse_mass, const DirectSettings& settings)
{
  const double stiffest = 1 / (settings.compliance * inverse_mass);
  return is_spring(row) ? std::min((1 / row.keeps - 1) / inverse_mass, stiffest) : stiffest;
}

/// The impulse [N s] of a row at no speed, but for its sign, in a step [s].
inline double offset_of(
    const ConstraintRow& row, double inverse_mass, double stiffness, double step,
    const DirectSettings& settings)
{
  if (is_spring(row)) // so that a single one comes to the speed that it asks
  {
    return (1 / inverse_mass + stiffness) * row.pulls * row.error;
  }
  const double correction = is_open(row) ? 1 : settings.row_correction;
  return stiffness * (correction * row.error / step - row.speed);
}

/// Adds the rows of a constraint.
inline void gather(
    std::vector<DirectRow>& rows, IslandView world, const Island& island,
    const ConstraintPair& pair, double step, const DirectSettings& settings)
{
  const RigidBody& a = world.bodies[index_of(pair.a)];
  const RigidBody& b = world.bodies[index_of(pair.b)];
  const int in_a = number_in(island, pair.a), in_b = number_in(island, pair.b);
  world.sets[pair.set]->rows(
      a, b, pair.number, step,
      [&](const ConstraintRow& row)
      {
        DirectRow& made = rows.emplace_back(DirectRow{in_a, in_b, row.a, row.b, &pair});
        const double inverse_mass = inverse_mass_of(a, row.a) + inverse_mass_of(b, row.b);
        if (inverse_mass == 0)
        {
          return; // it moves nothing
        }
        const double driven = (in_a < 0 ? row.a.dot(velocities_of(a.motion)) : 0) +
                              (in_b < 0 ? row.b.dot(velocities_of(b.motion)) : 0);
        made.stiffness = stiffness_of(row, inverse_mass, settings);
        made.offset =
            offset_of(row, inverse_mass, made.stiffness, step, settings) + made.stiffness * driven;
        made.lower = step * row.lower;
        made.upper = step * row.upper;
        made.bends = !is_spring(row) && !row.motor;
        made.error = row.error;
      });
}

/// Guesses that motors reach their speeds: leaves both of their bounds out of the first change.
inline void guess_motors(std::vector<DirectRow>& rows)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for (DirectRow& row : rows)
  {
    row.unbounded = row.lower > -infinity && row.upper < infinity && row.stiffness > 0;
  }
}

/// Gives rows their bounds back; whether any was without them.
inline bool bound_all(std::vector<DirectRow>& rows)
{
  bool any = false;
  for (DirectRow& row : rows)
  {
    any = any || row.unbounded;
    row.unbounded = false;
  }
  return any;
}

/// Adds the stiffness of rows to a matrix: Jᵀ k J.
inline void add_rows(const std::vector<DirectRow>& rows, BlockCholesky& matrix)
{
  for (const DirectRow& row : rows)
  {
    if (row.at != 0)
    {
      continue;
    }
    if (row.a >= 0)
    {
      matrix.diagonal(row.a) += row.stiffness * row.on_a * row.on_a.transpose();
    }
    if (row.b >= 0)
    {
      matrix.diagonal(row.b) += row.stiffness * row.on_b * row.on_b.transpose();
    }
    if (row.a >= 0 && row.b >= 0)
    {
      matrix.add_coupling(row.a, row.b, row.stiffness * row.on_a * row.on_b.transpose());
    }
  }
}

/// Sets the impulse of a row at the present velocities, and adds it to its bodies' residuals.
inline void
update_row(DirectRow& row, const std::vector<Vector6>& velocities, std::vector<Vector6>& residual)
{
  double speed = row.a >= 0 ? row.on_a.dot(velocities[index_of(row.a)]) : 0;
  speed += row.b >= 0 ? row.on_b.dot(velocities[index_of(row.b)]) : 0;
  const double push = -row.stiffness * speed - row.offset;
  row.at = row.unbounded ? 0 : push < row.lower ? -1 : push > row.upper ? 1 : 0;
  row.impulse = row.at < 0 ? row.lower : row.at > 0 ? row.upper : push;
  if (row.a >= 0)
  {
    residual[index_of(row.a)] += row.impulse * row.on_a;
  }
  if (row.b >= 0)
  {
    residual[index_of(row.b)] += row.impulse * row.on_b;
  }
}
// [direct_rows]

} // namespace cookbook
