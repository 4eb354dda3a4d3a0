#pragma once

/// \file
/// \brief What a limit, a motor or a spring of a joint feels where its rigid rows hold.

#include "06_world/constraints/joint_rows.hpp"

#include <cstddef>

namespace cookbook
{

// [free_row]
/// A row of a joint without what its rigid rows take: a push along it leaves their speeds as they
/// are. So the limit of a hinge feels how a door turns about the hinge, not about its centre.
struct FreeRow
{
  Vector6 a, b;     ///< J
  RigidVector held; ///< [1], pushes along the rigid rows that go with a push of 1
  double mass;      ///< 1/K [kg]; 0 where the rigid rows leave nothing
};

/// That of a row, by the factor of the rigid rows' K: J less K_ir K_rr⁻¹ J_r; R36.
inline FreeRow free_row(
    const JointRows& rows, std::size_t i, const Eigen::LDLT<RigidMatrix>& factor,
    const Body<double>& a, const Body<double>& b)
{
  const ConstraintRow& row = rows[i];
  const std::size_t count = rows.rigid();
  FreeRow free{row.a, row.b, RigidVector(static_cast<Eigen::Index>(count)), 0};
  const double alone = inverse_mass_of(a, row.a) + inverse_mass_of(b, row.b);
  if (count > 0)
  {
    const Vector6 on_a = given_by(a, row.a), on_b = given_by(b, row.b);
    for (std::size_t r = 0; r < count; ++r)
    {
      free.held[static_cast<Eigen::Index>(r)] = rows[r].a.dot(on_a) + rows[r].b.dot(on_b);
    }
    free.held = factor.solve(free.held).eval();
    for (std::size_t r = 0; r < count; ++r)
    {
      free.a -= free.held[static_cast<Eigen::Index>(r)] * rows[r].a;
      free.b -= free.held[static_cast<Eigen::Index>(r)] * rows[r].b;
    }
  }
  const double left = inverse_mass_of(a, free.a) + inverse_mass_of(b, free.b);
  free.mass = left > 1e-12 * alone ? 1 / left : 0;
  return free;
}

/// The speed [m/s, rad/s] along such a row.
inline double free_speed(const FreeRow& row, const Motion<double>& a, const Motion<double>& b)
{
  return row.a.dot(velocities_of(a)) + row.b.dot(velocities_of(b));
}

/// The change [N s, N m s] of a spring's impulse, with its coefficients for the mass of its row
/// alone, where it feels another, and has pushed by `impulse` in this step.
inline double
spring_change(const ConstraintRow& row, double alone, double mass, double speed, double impulse)
{
  const double gives = (1 - row.keeps) * alone;
  return -(gives * speed + alone * row.pulls * row.error + row.keeps * impulse) /
         (row.keeps + gives / mass);
}

/// Corrects the velocities of two bodies once along one row, in a substep [s], and adds to its
/// impulse so far, and to those of the rigid rows.
inline void solve_row(
    const JointRows& rows, std::size_t i, const Eigen::LDLT<RigidMatrix>& factor, Body<double>& a,
    Body<double>& b, const Softness<double>& softness, double substep, JointImpulses& impulses)
{
  const ConstraintRow& row = rows[i];
  const FreeRow free = free_row(rows, i, factor, a, b);
  const double speed = free_speed(free, a.motion, b.motion);
  double change;
  if (free.mass == 0) // it moves nothing
  {
    return;
  }
  if (is_spring(row))
  {
    change = spring_change(row, row_mass(row, a, b), free.mass, speed, impulses[i]);
  }
  else if (is_open(row)) // a limit that is not reached: may close
  {
    change = -free.mass * (speed + row.error / substep);
  }
  else
  {
    const Softness<double> soft = row.motor ? rigid<double>() : softness; // it has no error
    const double bias = soft.bias_rate * row.error + substep / 2 * row.turning - row.speed;
    change = -free.mass * soft.mass_scale * (speed + bias) - soft.impulse_scale * impulses[i];
  }
  const double sum = std::clamp(impulses[i] + change, substep * row.lower, substep * row.upper);
  change = sum - impulses[i];
  impulses[i] = sum;
  for (std::size_t r = 0; r < rows.rigid(); ++r)
  {
    impulses[r] -= free.held[static_cast<Eigen::Index>(r)] * change;
  }
  push_along(a, free.a, change);
  push_along(b, free.b, change);
}
// [free_row]

} // namespace cookbook
