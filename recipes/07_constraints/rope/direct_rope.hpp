#pragma once

/// \file
/// \brief All links of a rope at once: one system of equations for their impulses.

#include "07_constraints/particles/checked_particles.hpp"
#include "07_constraints/rope/rope_links.hpp"
#include "07_constraints/rope/tridiagonal.hpp"

#include <span>
#include <vector>

namespace cookbook
{

// [correct_links]
/// The directions of all links.
inline std::vector<Vector3<double>>
directions_of(const Particles& particles, std::span<const DistanceConstraint> links)
{
  std::vector<Vector3<double>> directions;
  for (const DistanceConstraint& link : links)
  {
    directions.push_back(direction_of(particles, link).unit);
  }
  return directions;
}

/// Corrects all links at once by impulses along the directions d: C + J W Dᵀ λ = 0; R47.
///
/// A billionth is added to the diagonal, for a straight rope between two pins, whose equations say
/// one thing twice. A link between two pins is left as it is.
inline void correct_links(
    Particles& particles, std::span<const DistanceConstraint> links,
    const std::vector<Vector3<double>>& d)
{
  std::vector<TridiagonalRow<1>> rows(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    const Direction<double> n = direction_of(particles, links[i]);
    const double w_a = particles.inverse_masses[i], w_b = particles.inverse_masses[i + 1];
    rows[i].right(0) = w_a + w_b > 0 ? links[i].length - n.length : 0;
    rows[i].diagonal(0) = w_a + w_b > 0 ? (1 + 1e-9) * (w_a + w_b) * n.unit.dot(d[i]) : 1;
    rows[i].before(0) = i > 0 ? -w_a * n.unit.dot(d[i - 1]) : 0;
    rows[i].after(0) = i + 1 < links.size() ? -w_b * n.unit.dot(d[i + 1]) : 0;
  }
  const std::vector<Vector<double, 1>> impulses = solve_tridiagonal(rows);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    particles.positions[i] -= particles.inverse_masses[i] * impulses[i](0) * d[i];
    particles.positions[i + 1] += particles.inverse_masses[i + 1] * impulses[i](0) * d[i];
  }
}
// [correct_links]

// [step_direct]
/// Where the impulses of links point: as the links do now, or as they did when the substep began.
enum class LinkDirections
{
  current,
  previous
};

/// Moves a rope on by a step that keeps the lengths of all links, whatever hangs on it; R47.
///
/// `previous` keeps the energy and may explode where links turn by more than a right angle in a
/// substep; `current` never gains and loses as implicit Euler does. Both need a substep below
/// √(m L / T). Throws std::invalid_argument, with member and value, where a number is not finite,
/// a link has a compliance, or constraint i does not join particles i and i+1.
inline void step_direct(
    Particles& particles, std::span<const DistanceConstraint> links, const StepSettings& settings,
    LinkDirections directions = LinkDirections::previous)
{
  check(particles, links, settings);
  check_rope(links);
  const double h = settings.step / settings.substeps;
  for (int substep = 0; substep < settings.substeps; ++substep)
  {
    const std::vector<Vector3<double>> before = particles.positions;
    std::vector<Vector3<double>> d = directions_of(particles, links);
    apply_gravity(particles, settings, h);
    move_particles(particles, h);
    for (int iteration = 0; iteration < settings.iterations; ++iteration)
    {
      d = directions == LinkDirections::current ? directions_of(particles, links) : d;
      correct_links(particles, links, d);
    }
    derive_velocities(particles, before, h);
  }
}
// [step_direct]

} // namespace cookbook
