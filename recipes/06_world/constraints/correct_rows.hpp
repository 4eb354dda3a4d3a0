#pragma once

/// \file
/// \brief The rows of one joint for a solver of positions: bodies are moved, not pushed.

#include "06_world/constraints/free_row.hpp"
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

/// The push [kg m, kg m²] along a row that is not rigid, after a substep [s] with the velocities as
/// they are, where its error is `error` [m, rad] by now; springs and motors in the first pass.
inline double wanted_push(
    const ConstraintRow& row, const FreeRow& free, const RigidBody& a, const RigidBody& b,
    double error, double substep, bool first)
{
  const double speed = free_speed(free, a.motion, b.motion);
  if (is_limit(row))
  {
    return -free.mass * error;
  }
  if (is_spring(row) && first)
  {
    ConstraintRow before = row;
    before.error -= substep * speed;
    return substep * spring_change(before, row_mass(row, a, b), free.mass, speed, 0);
  }
  return first ? substep * free.mass * (row.speed - speed) : 0;
}

/// Corrects two bodies once along all rows of a joint: those that are not rigid in turn, then all
/// rigid ones together, by the factor of their K; R15. Returns the impulses [N s, N m s] that would
/// have done the same.
inline JointImpulses correct_rows(
    const JointRows& rows, RigidBody& a, RigidBody& b, const Eigen::LDLT<RigidMatrix>& factor,
    double substep, bool first)
{
  const std::size_t rigid = rows.rigid();
  const double squared = substep * substep;
  JointImpulses impulses{};
  Vector6 moved_a = Vector6::Zero(), moved_b = Vector6::Zero();
  for (std::size_t i = rigid; i < rows.size(); ++i)
  {
    const ConstraintRow& row = rows[i];
    const FreeRow free = free_row(rows, i, factor, a, b);
    if (free.mass == 0)
    {
      continue;
    }
    const double error = row.error + row.a.dot(moved_a) + row.b.dot(moved_b);
    const double push = std::clamp(
        wanted_push(row, free, a, b, error, substep, first), squared * row.lower,
        squared * row.upper);
    moved_a += push * given_by(a, free.a);
    moved_b += push * given_by(b, free.b);
    impulses[i] = push / substep;
    for (std::size_t r = 0; r < rigid; ++r)
    {
      impulses[r] -= free.held[static_cast<Eigen::Index>(r)] * push / substep;
    }
    move_along(a, free.a, push);
    move_along(b, free.b, push);
  }
  RigidVector errors(static_cast<Eigen::Index>(rigid));
  for (std::size_t i = 0; i < rigid; ++i)
  {
    errors[static_cast<Eigen::Index>(i)] = rows[i].error;
  }
  const RigidVector pushes = factor.solve(errors);
  for (std::size_t i = 0; i < rigid; ++i)
  {
    const double push = -pushes[static_cast<Eigen::Index>(i)];
    move_along(a, rows[i].a, push);
    move_along(b, rows[i].b, push);
    impulses[i] += push / substep;
  }
  return impulses;
}
// [correct_rows]

} // namespace cookbook
