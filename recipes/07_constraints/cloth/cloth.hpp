#pragma once

/// \file
/// \brief A cloth of particles in wind and on obstacles, by XPBD with substeps.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "07_constraints/cloth/cloth_contacts.hpp"
#include "07_constraints/cloth/cloth_grid.hpp"
#include "07_constraints/cloth/wind.hpp"
#include "07_constraints/particles/xpbd.hpp"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

/// Throws std::invalid_argument unless obstacles are shapes, and their numbers make sense.
inline void check(const Obstacles& obstacles)
{
  for (const Plane<double>& plane : obstacles.planes)
  {
    checked(plane);
  }
  for (const Sphere<double>& sphere : obstacles.spheres)
  {
    checked(sphere);
  }
  for (const Capsule<double>& capsule : obstacles.capsules)
  {
    checked(capsule);
  }
  for (const Obb<double>& box : obstacles.boxes)
  {
    checked(box);
  }
  check_setting("friction", obstacles.friction, 0, largest_number);
  check_setting("thickness", obstacles.thickness, 0, largest_number);
}

/// Throws std::invalid_argument unless each triangle has particles that there are.
inline void check(const std::vector<std::array<std::size_t, 3>>& triangles, std::size_t count)
{
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto [a, b, c] = triangles[i];
    if (a >= count || b >= count || c >= count)
    {
      throw std::invalid_argument(
          "triangles[" + std::to_string(i) + "] must join three of " + std::to_string(count) +
          " particles, got " + std::to_string(a) + ", " + std::to_string(b) + " and " +
          std::to_string(c));
    }
  }
}

// [step_cloth]
/// The air around a cloth.
struct Air
{
  Vector3<double> wind{0, 0, 0}; ///< [m/s]
  double density = 1.2;          ///< [kg/m³], times the drag coefficient; 0: no air
};

/// Moves a cloth on by a step: gravity and wind change the velocities, distances and contacts
/// correct the positions.
///
/// Throws std::invalid_argument, with member and value, where a number is not finite or makes no
/// sense. Source: Müller et al. 2007, Macklin et al. 2014 and 2019.
inline void step_cloth(
    Cloth& cloth, const StepSettings& settings, const Obstacles& obstacles = {},
    const Air& air = {})
{
  Particles& particles = cloth.particles;
  check(particles, cloth.constraints, settings);
  check(cloth.triangles, particles.positions.size());
  check(obstacles);
  check_setting("density", air.density, 0, largest_number);
  check_setting("wind.x", air.wind.x(), -largest_number, largest_number);
  check_setting("wind.y", air.wind.y(), -largest_number, largest_number);
  check_setting("wind.z", air.wind.z(), -largest_number, largest_number);
  const double h = settings.step / settings.substeps;
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    const std::vector<Vector3<double>> before = particles.positions;
    apply_gravity(particles, settings, h);
    for (const std::array<std::size_t, 3>& triangle : cloth.triangles)
    {
      apply_wind(particles, triangle, air.wind, air.density, h);
    }
    move_particles(particles, h);
    correct_distances(particles, cloth.constraints, settings.iterations, h);
    correct_contacts(particles, before, obstacles);
    derive_velocities(particles, before, h);
  }
}
// [step_cloth]

} // namespace cookbook
