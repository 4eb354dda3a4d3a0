#pragma once

/// \file
/// \brief A rope of masses and springs, moved by the forces at the start of each step.

#include "07_constraints/particles/checked_particles.hpp"

#include <span>

namespace cookbook
{

// [spring_force]
/// The force [N] of a spring on its particle B, and its opposite on A; R44.
inline Vector3<double> spring_force(const Particles& particles, const DistanceConstraint& spring)
{
  const Direction<double> n = direction_of(particles, spring);
  return -(n.length - spring.length) / spring.compliance * n.unit;
}
// [spring_force]

/// Throws std::invalid_argument unless each constraint is a spring: the stiffness, one over its
/// compliance, is 1e12 N/m at most.
inline void check_springs(std::span<const DistanceConstraint> springs)
{
  for (std::size_t i = 0; i < springs.size(); ++i)
  {
    check_between("constraints", i, ".compliance", springs[i].compliance, 1e-12, largest_number);
  }
}

// [step_mass_spring]
/// Moves particles on springs by a step, with symplectic Euler: it explodes where a spring is stiff
/// and the step long; R44.
///
/// Throws std::invalid_argument, with member and value, where a number is not finite, a compliance
/// is below 1e-12, or a particle has been thrown beyond 1e9.
inline void step_mass_spring(
    Particles& particles, std::span<const DistanceConstraint> springs, const StepSettings& settings)
{
  check(particles, springs, settings);
  check_springs(springs);
  const double h = settings.step / settings.substeps;
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    apply_gravity(particles, settings, h);
    for (const DistanceConstraint& spring : springs)
    {
      const Vector3<double> force = spring_force(particles, spring);
      particles.velocities[spring.a] -= h * particles.inverse_masses[spring.a] * force;
      particles.velocities[spring.b] += h * particles.inverse_masses[spring.b] * force;
    }
    move_particles(particles, h);
  }
  check(particles);
}
// [step_mass_spring]

} // namespace cookbook
