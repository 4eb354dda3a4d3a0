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
/// Corrects all links at once, in a substep h [s], by impulses along the directions d, and adds
/// these to the `impulses` [kg m] so far; R47.
///
/// A billionth is added to the diagonal, for a straight rope between two pins, whose equations say
/// one thing twice. A link between two pins is left as it is.
inline void correct_links(
    Particles& particles, std::span<const DistanceConstraint> links,
    const std::vector<Vector3<double>>& d, std::vector<double>& impulses, double h)
{
  std::vector<TridiagonalRow<1>> rows(links.size());
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    const Direction<double> n = direction_of(particles, links[i]);
    const double w_a = particles.inverse_masses[i], w_b = particles.inverse_masses[i + 1];
    const double alpha = links[i].compliance / (h * h), w = (1 + 1e-9) * (w_a + w_b);
    rows[i].right(0) = w > 0 ? -(n.length - links[i].length) - alpha * impulses[i] : 0;
    rows[i].diagonal(0) = w > 0 ? w * n.unit.dot(d[i]) + alpha : 1;
    rows[i].before(0) = i > 0 ? -w_a * n.unit.dot(d[i - 1]) : 0;
    rows[i].after(0) = i + 1 < links.size() ? -w_b * n.unit.dot(d[i + 1]) : 0;
  }
  const std::vector<Vector<double, 1>> changes = solve_tridiagonal(rows);
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    impulses[i] += changes[i](0);
    particles.positions[i] -= particles.inverse_masses[i] * changes[i](0) * d[i];
    particles.positions[i + 1] += particles.inverse_masses[i + 1] * changes[i](0) * d[i];
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

/// The directions of all links, `previous` ones where these are asked for; a link that has turned
/// by more than 60° since has its current one, for across itself it could not be corrected.
inline std::vector<Vector3<double>> directions_of(
    const Particles& particles, std::span<const DistanceConstraint> links,
    LinkDirections directions, const std::vector<Vector3<double>>& previous)
{
  std::vector<Vector3<double>> along;
  for (std::size_t i = 0; i < links.size(); ++i)
  {
    const Vector3<double> now = direction_of(particles, links[i]).unit;
    const bool keeps = directions == LinkDirections::previous && now.dot(previous[i]) > 0.5;
    along.push_back(keeps ? previous[i] : now);
  }
  return along;
}

/// Moves a rope on by a step that keeps the lengths of all links, whatever hangs on it; R47.
///
/// `previous` keeps the energy and may explode where links turn far within a substep; `current`
/// loses what implicit Euler does. Both need a substep below √(m L / T). Throws
/// std::invalid_argument, with member and value, where a number is not finite, constraint i does
/// not join particles i and i+1, or a particle has been thrown beyond 1e9.
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
    const std::vector<Vector3<double>> previous =
        directions_of(particles, links, LinkDirections::current, {});
    std::vector<double> impulses(links.size(), 0.0);
    apply_gravity(particles, settings, h);
    move_particles(particles, h);
    for (int iteration = 0; iteration < settings.iterations; ++iteration)
    {
      const auto d = directions_of(particles, links, directions, previous);
      correct_links(particles, links, d, impulses, h);
    }
    derive_velocities(particles, before, h);
  }
  check(particles);
}
// [step_direct]

} // namespace cookbook
