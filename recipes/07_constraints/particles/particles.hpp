#pragma once

/// \file
/// \brief Particles and the distances between them: plain data, what ropes and cloths are made of.

#include "common/math/norm.hpp"

#include <cstddef>
#include <vector>

namespace cookbook
{

// [particles]
/// Particles: points with a mass. All three lists have one entry for each.
struct Particles
{
  std::vector<Vector3<double>> positions;  ///< [m], world
  std::vector<Vector3<double>> velocities; ///< [m/s], world
  std::vector<double> inverse_masses;      ///< [1/kg]; 0: pinned, it only goes on with its velocity
};

/// Two particles that keep a distance.
struct DistanceConstraint
{
  std::size_t a, b;      ///< two different particles
  double length;         ///< [m], at rest, zero or more
  double compliance = 0; ///< [m/N], how far a newton stretches it; 0: not at all
};

/// How a step is made.
struct StepSettings
{
  double step = 1.0 / 60;               ///< [s], of a frame
  Vector3<double> gravity{0, -9.81, 0}; ///< [m/s²]
  double damping = 0;                   ///< [1/s], rate at which velocities are damped by the air
  int substeps = 1;                     ///< parts of a step
  int iterations = 1;                   ///< times that all constraints are solved in each part
};

/// From particle A to particle B: unit direction and distance [m]; two in one place: +y, 0.
inline Direction<double> direction_of(const Particles& particles, const DistanceConstraint& pair)
{
  return normalize<double>(particles.positions[pair.b] - particles.positions[pair.a]);
}
// [particles]

// [integrate]
/// Changes the velocities by gravity and by what damps them, for a substep h [s].
inline void apply_gravity(Particles& particles, const StepSettings& settings, double h)
{
  for (std::size_t i = 0; i < particles.positions.size(); ++i)
  {
    if (particles.inverse_masses[i] > 0)
    {
      particles.velocities[i] /= 1 + h * settings.damping;
      particles.velocities[i] += h * settings.gravity;
    }
  }
}

/// Moves the particles by their velocities for a substep h [s].
inline void move_particles(Particles& particles, double h)
{
  for (std::size_t i = 0; i < particles.positions.size(); ++i)
  {
    particles.positions[i] += h * particles.velocities[i];
  }
}

/// Gives each particle the velocity with which it has come from where it was a substep h [s] ago.
inline void
derive_velocities(Particles& particles, const std::vector<Vector3<double>>& before, double h)
{
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    particles.velocities[i] = (particles.positions[i] - before[i]) / h;
  }
}
// [integrate]

} // namespace cookbook
