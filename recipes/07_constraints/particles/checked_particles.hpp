#pragma once

/// \file
/// \brief The check that particles, their constraints and a step make sense.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "07_constraints/particles/particles.hpp"

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>

namespace cookbook
{

/// Numbers of particles, without sign, are at most this, and what is not zero of their inverse
/// masses at least one over it. What grows beyond it has exploded.
inline constexpr double largest_number = 1e9;

/// Throws std::invalid_argument unless a member of the i-th entry of a list lies between two
/// others.
inline void check_between(
    const char* list, std::size_t i, const char* member, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(
        std::string(list) + "[" + std::to_string(i) + "]" + member + " must be between " +
        text_of(least) + " and " + text_of(most) + ", got " + text_of(value));
  }
}

/// The same of the components of a vector, without their signs.
inline void check_vector(const char* list, std::size_t i, const Vector3<double>& value)
{
  check_between(list, i, ".x", value.x(), -largest_number, largest_number);
  check_between(list, i, ".y", value.y(), -largest_number, largest_number);
  check_between(list, i, ".z", value.z(), -largest_number, largest_number);
}

/// The same of a setting.
inline void check_setting(const char* name, double value, double least, double most)
{
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(
        std::string(name) + " must be between " + text_of(least) + " and " + text_of(most) +
        ", got " + text_of(value));
  }
}

// [check_particles]
/// Throws std::invalid_argument, with member and value, unless there is a velocity and an inverse
/// mass for each position, and all numbers are finite and up to 1e9.
inline void check(const Particles& particles)
{
  const std::size_t count = particles.positions.size();
  if (particles.velocities.size() != count || particles.inverse_masses.size() != count)
  {
    throw std::invalid_argument(
        "velocities and inverse_masses must be as many as positions, " + std::to_string(count) +
        ", got " + std::to_string(particles.velocities.size()) + " and " +
        std::to_string(particles.inverse_masses.size()));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    check_vector("positions", i, particles.positions[i]);
    check_vector("velocities", i, particles.velocities[i]);
    const double w = particles.inverse_masses[i];
    check_between("inverse_masses", i, "", w, w == 0 ? 0 : 1 / largest_number, largest_number);
  }
}

/// The same of constraints between `count` particles: places in the lists, lengths, compliances.
inline void check(std::span<const DistanceConstraint> constraints, std::size_t count)
{
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    const DistanceConstraint& one = constraints[i];
    if (one.a >= count || one.b >= count || one.a == one.b)
    {
      throw std::invalid_argument(
          "constraints[" + std::to_string(i) + "] must join two of " + std::to_string(count) +
          " particles, got " + std::to_string(one.a) + " and " + std::to_string(one.b));
    }
    check_between("constraints", i, ".length", one.length, 0, largest_number);
    check_between("constraints", i, ".compliance", one.compliance, 0, largest_number);
  }
}

/// The same of the settings of a step.
inline void check(const StepSettings& settings)
{
  check_setting("step", settings.step, 1e-6, 1);
  check_setting("gravity.x", settings.gravity.x(), -largest_number, largest_number);
  check_setting("gravity.y", settings.gravity.y(), -largest_number, largest_number);
  check_setting("gravity.z", settings.gravity.z(), -largest_number, largest_number);
  check_setting("damping", settings.damping, 0, largest_number);
  check_setting("substeps", settings.substeps, 1, 1e6);
  check_setting("iterations", settings.iterations, 1, 1e6);
}
// [check_particles]

/// The particles, their constraints and the settings of a step.
inline void check(
    const Particles& particles, std::span<const DistanceConstraint> constraints,
    const StepSettings& settings)
{
  check(particles);
  check(constraints, particles.positions.size());
  check(settings);
}

} // namespace cookbook
