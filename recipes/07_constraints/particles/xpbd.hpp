#pragma once

/// \file
/// \brief Distances of particles, corrected one after the other: extended position-based dynamics.

#include "07_constraints/particles/checked_particles.hpp"

#include <span>
#include <vector>

namespace cookbook
{

// [correct_distance]
/// Moves two particles along the line between them until their distance is that of the constraint,
/// or as far from it as its compliance over h², [m/N/s²], allows; R46.
///
/// `impulse`, λ [kg m], is what this constraint has done in this substep. Two particles in one
/// place are taken for one above the other, B on top; of two pinned ones neither moves.
inline void correct_distance(
    Particles& particles, const DistanceConstraint& pair, double compliance, double& impulse)
{
  const double w_a = particles.inverse_masses[pair.a], w_b = particles.inverse_masses[pair.b];
  if (w_a + w_b > 0)
  {
    const Direction<double> n = direction_of(particles, pair);
    const double error = n.length - pair.length;
    const double change = -(error + compliance * impulse) / (w_a + w_b + compliance);
    impulse += change;
    particles.positions[pair.a] -= w_a * change * n.unit;
    particles.positions[pair.b] += w_b * change * n.unit;
  }
}
// [correct_distance]

// [step_xpbd]
/// Corrects all distances, one after the other, `iterations` times, for a substep h [s].
inline void correct_distances(
    Particles& particles, std::span<const DistanceConstraint> constraints, int iterations, double h)
{
  std::vector<double> impulses(constraints.size(), 0.0);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    for (std::size_t i = 0; i < constraints.size(); ++i)
    {
      const double compliance = constraints[i].compliance / (h * h);
      correct_distance(particles, constraints[i], compliance, impulses[i]);
    }
  }
}

/// Moves particles on by a step: predicts positions, corrects them, and derives velocities.
///
/// Throws std::invalid_argument, with member and value, where a number is not finite or makes no
/// sense. Source: Macklin, Müller and Chentanez 2016.
inline void step_xpbd(
    Particles& particles, std::span<const DistanceConstraint> constraints,
    const StepSettings& settings)
{
  check(particles, constraints, settings);
  const double h = settings.step / settings.substeps;
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    const std::vector<Vector3<double>> before = particles.positions;
    apply_gravity(particles, settings, h);
    move_particles(particles, h);
    correct_distances(particles, constraints, settings.iterations, h);
    derive_velocities(particles, before, h);
  }
}
// [step_xpbd]

} // namespace cookbook
