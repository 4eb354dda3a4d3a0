#pragma once

/// \file
/// \brief Augmented vertex block descent in its plainest form: particles that keep distances.

#include "07_constraints/avbd/avbd_settings.hpp"
#include "07_constraints/particles/checked_particles.hpp"

#include <Eigen/Cholesky>

#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

// [distance_error]
/// How far [m] two particles are from their distance, less a fraction of what they were off before
/// the step: so an old error is taken away over several steps.
inline double distance_error(
    const Particles& particles, const std::vector<Vector3<double>>& before,
    const DistanceConstraint& pair, const AvbdSettings& settings)
{
  const double off = direction_of(particles, pair).length - pair.length;
  const double old = normalize<double>(before[pair.b] - before[pair.a]).length - pair.length;
  return off - settings.stabilization * old;
}
// [distance_error]

// [settle_particle]
/// Moves one particle to where the forces on it balance, with all others where they are: inertia
/// draws it to `alone`, each of its constraints pushes by λ − k C; R68.
inline void settle_particle(
    Particles& particles, std::size_t i, const Vector3<double>& alone,
    const std::vector<Vector3<double>>& before, std::span<const DistanceConstraint> constraints,
    std::span<const AvbdMemory> memories, const AvbdSettings& settings, double h)
{
  const double inertia = 1 / (particles.inverse_masses[i] * h * h);
  Vector3<double> force = inertia * (alone - particles.positions[i]);
  Matrix3<double> stiffness = inertia * Matrix3<double>::Identity();
  for (std::size_t c = 0; c < constraints.size(); ++c)
  {
    const DistanceConstraint& pair = constraints[c];
    if (pair.a == i || pair.b == i)
    {
      const Direction<double> n = direction_of(particles, pair);
      const double error = distance_error(particles, before, pair, settings);
      const double push = memories[c].push - memories[c].stiffness * error;
      const Matrix3<double> along = n.unit * n.unit.transpose();
      force += (pair.b == i ? push : -push) * n.unit;
      stiffness += memories[c].stiffness * along;
      if (n.length > 0) // across, it is as stiff as it is taut
      {
        stiffness += std::abs(push) / n.length * (Matrix3<double>::Identity() - along);
      }
    }
  }
  particles.positions[i] += stiffness.ldlt().solve(force);
}
// [settle_particle]

// [step_plain_avbd]
/// Moves particles on by a step: each in turn goes to where its forces balance, pass by pass, and
/// after each pass the constraints grow stiffer.
///
/// `settings.iterations` are the passes; those of `descent` are not read. `memories` has one entry
/// for each constraint; what is missing is added. Compliance is not read: lengths are exact in the
/// end. Throws std::invalid_argument as step_xpbd() does. Source: Giles,
/// Diaz and Yuksel 2025.
inline void step_plain_avbd(
    Particles& particles, std::span<const DistanceConstraint> constraints,
    std::vector<AvbdMemory>& memories, const StepSettings& settings,
    const AvbdSettings& descent = {})
{
  check(particles, constraints, settings);
  const double h = settings.step / settings.substeps;
  memories.resize(constraints.size(), {0, descent.least});
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    const std::vector<Vector3<double>> before = particles.positions;
    apply_gravity(particles, settings, h);
    move_particles(particles, h);
    const std::vector<Vector3<double>> alone = particles.positions;
    for (AvbdMemory& memory : memories)
    {
      memory = warm_start(memory, descent);
    }
    for (int pass = 0; pass < settings.iterations; ++pass)
    {
      for (std::size_t i = 0; i < alone.size(); ++i)
      {
        if (particles.inverse_masses[i] > 0)
        {
          settle_particle(particles, i, alone[i], before, constraints, memories, descent, h);
        }
      }
      for (std::size_t c = 0; c < constraints.size(); ++c)
      {
        update(memories[c], distance_error(particles, before, constraints[c], descent), descent);
      }
    }
    derive_velocities(particles, before, h);
  }
}
// [step_plain_avbd]

} // namespace cookbook
