#pragma once

/// \file
/// \brief The rows of one joint for a solver of positions: bodies are moved, not pushed.

#include "06_world/constraints/joint_rows.hpp"
#include "06_world/contacts/integrate_body.hpp"

namespace cookbook
{

// [correct_rows]
/// Moves a body by a push [kg m, kg m²] along a row of it.
inline void move_along(RigidBody& body, const Vector6& row, double push)
{
  if (!is_fixed(body))
  {
    body.motion.center += body.inverse_mass * push * row.head<3>();
    turn_by(body, push * (body.inverse_inertia * row.tail<3>()));
  }
}

/// By how much [m, rad] the error of a row that is not rigid has to change, after a substep [s]
/// with the velocities as they are; springs and motors in the first pass.
inline double wanted_change(
    const ConstraintRow& row, const RigidBody& a, const RigidBody& b, double substep, bool first)
{
  const double speed = row_speed(row, a.motion, b.motion);
  if (is_spring(row))
  {
    const double before = row.error - substep * speed;
    return first ? substep * ((row.keeps - 1) * speed - row.pulls * before) : 0;
  }
  return is_limit(row) ? -row.error : first ? substep * (row.speed - speed) : 0;
}

/// Corrects two bodies once along all rows of a joint: those that are not rigid in turn, then all
/// rigid ones together, by the factor of their K; R15.
inline void correct_rows(
    const JointRows& rows, RigidBody& a, RigidBody& b, const Eigen::LDLT<RigidMatrix>& factor,
    double substep, bool first)
{
  const std::size_t rigid = rows.rigid();
  const double squared = substep * substep;
  for (std::size_t i = rigid; i < rows.size(); ++i)
  {
    const ConstraintRow& row = rows[i];
    const double push = std::clamp(
        row_mass(row, a, b) * wanted_change(row, a, b, substep, first), squared * row.lower,
        squared * row.upper);
    move_along(a, row.a, push);
    move_along(b, row.b, push);
  }
  RigidVector errors(static_cast<Eigen::Index>(rigid));
  for (std::size_t i = 0; i < rigid; ++i)
  {
    errors[static_cast<Eigen::Index>(i)] = rows[i].error;
  }
  const RigidVector pushes = factor.solve(errors);
  for (std::size_t i = 0; i < rigid; ++i)
  {
    move_along(a, rows[i].a, -pushes[static_cast<Eigen::Index>(i)]);
    move_along(b, rows[i].b, -pushes[static_cast<Eigen::Index>(i)]);
  }
}
// [correct_rows]

} // namespace cookbook
