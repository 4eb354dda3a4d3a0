#pragma once

/// \file
/// \brief A rope of masses and springs, moved by the forces at the end of each step.

#include "07_constraints/particles/checked_particles.hpp"
#include "07_constraints/rope/mass_spring.hpp"
#include "07_constraints/rope/rope_links.hpp"
#include "07_constraints/rope/tridiagonal.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace cookbook
{

// [spring_jacobian]
/// How the force of a spring [N] on B changes with B's position, in N/m; R45.
///
/// Along the spring by its stiffness, across it by the tension over the length; a spring that is
/// pushed would buckle, and what that adds is left out.
inline Matrix3<double> spring_jacobian(const Particles& particles, const DistanceConstraint& spring)
{
  const Direction<double> n = direction_of(particles, spring);
  const double across = n.length > spring.length ? 1 - spring.length / n.length : 0;
  const Matrix3<double> along = n.unit * n.unit.transpose();
  return -(along + across * (Matrix3<double>::Identity() - along)) / spring.compliance;
}
// [spring_jacobian]

// [implicit_equations]
/// The equations for the changes of all velocities in a substep h [s]; R45.
inline std::vector<TridiagonalRow<3>> implicit_equations(
    const Particles& particles, std::span<const DistanceConstraint> springs, double h)
{
  std::vector<TridiagonalRow<3>> rows(particles.positions.size());
  for (TridiagonalRow<3>& row : rows)
  {
    row.diagonal.setIdentity();
  }
  for (const DistanceConstraint& spring : springs)
  {
    const Matrix3<double> k = spring_jacobian(particles, spring);
    const Vector3<double> speed = particles.velocities[spring.b] - particles.velocities[spring.a];
    const Vector3<double> impulse = h * (spring_force(particles, spring) + h * (k * speed));
    const double w_a = particles.inverse_masses[spring.a], w_b = particles.inverse_masses[spring.b];
    rows[spring.a].diagonal -= h * h * w_a * k;
    rows[spring.a].after += h * h * w_a * k;
    rows[spring.a].right -= w_a * impulse;
    rows[spring.b].diagonal -= h * h * w_b * k;
    rows[spring.b].before += h * h * w_b * k;
    rows[spring.b].right += w_b * impulse;
  }
  return rows;
}

// [implicit_equations]

// [step_implicit]
/// Moves a rope of springs by a step, with implicit Euler: one system of equations a substep, and
/// no step too long.
///
/// Throws std::invalid_argument as step_mass_spring does, and where constraint i does not join
/// particles i and i+1. Source: Baraff and Witkin 1998.
inline void step_implicit(
    Particles& particles, std::span<const DistanceConstraint> springs, const StepSettings& settings)
{
  check(particles, springs, settings);
  check_springs(springs);
  check_rope(springs);
  const double h = settings.step / settings.substeps;
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    apply_gravity(particles, settings, h);
    const std::vector<Vector3<double>> changes =
        solve_tridiagonal(implicit_equations(particles, springs, h));
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      particles.velocities[i] += changes[i];
    }
    move_particles(particles, h);
  }
}
// [step_implicit]

} // namespace cookbook
