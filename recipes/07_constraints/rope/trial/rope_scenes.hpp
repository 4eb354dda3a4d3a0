#pragma once

/// \file
/// \brief Ropes on trial: a cable between two hooks, a swing, a load.

#include "07_constraints/rope/trial/catenary.hpp"
#include "07_constraints/rope/trial/rope_methods.hpp"
#include "common/math/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <vector>

namespace cookbook
{

// [rope_scenes]
/// A cable of 10 m and 10 kg in 40 links, whose hooks are 8 m apart; it begins as a V, 3 m deep.
inline Rope cable(double compliance = 0)
{
  Rope rope = make_rope({0, 0, 0}, {10, 0, 0}, 40, 10, compliance);
  for (Vector3<double>& x : rope.particles.positions)
  {
    const double along = x.x();
    x = {0.8 * along - 4, 0.6 * (std::abs(along - 5) - 5), 0};
  }
  rope.particles.inverse_masses.front() = rope.particles.inverse_masses.back() = 0;
  return rope;
}

/// A rope of 5 m and 5 kg in 20 links, straight, its upper end held, at an angle [rad] from below.
inline Rope swing(double angle, double compliance = 0)
{
  const SineCosine<double> turn = sine_cosine(angle);
  Rope rope = make_rope({0, 0, 0}, {5 * turn.sine, -5 * turn.cosine, 0}, 20, 5, compliance);
  rope.particles.inverse_masses.front() = 0;
  return rope;
}

/// A rope of 5 m and 1 kg in 20 links that hangs straight down, and at its end a load [kg].
inline Rope loaded(double load, double compliance = 0)
{
  Rope rope = make_rope({0, 0, 0}, {0, -5, 0}, 20, 1, compliance);
  rope.particles.inverse_masses.front() = 0;
  rope.particles.inverse_masses.back() = 1 / load;
  return rope;
}
// [rope_scenes]

/// Moves a rope on by frames of 1/60 s, and calls `after(rope)` behind each.
template <class After>
void run_rope(Rope& rope, const RopeMethod& method, int frames, double damping, const After& after)
{
  StepSettings settings;
  settings.damping = damping;
  settings.substeps = method.substeps;
  settings.iterations = method.iterations;
  for (int frame = 0; frame < frames; ++frame)
  {
    method.step(rope, settings);
    after(rope);
  }
}

/// How far [m] the lowest particle is below the origin.
inline double lowest(const Rope& rope)
{
  double low = 0;
  for (const Vector3<double>& x : rope.particles.positions)
  {
    low = std::max(low, -x.y());
  }
  return low;
}

/// How much the link that is off most is longer or shorter than it should be [m].
inline double worst_stretch(const Rope& rope)
{
  double most = 0;
  for (const DistanceConstraint& link : rope.links)
  {
    most = std::max(most, std::abs(direction_of(rope.particles, link).length - link.length));
  }
  return most;
}

/// Kinetic, potential and elastic energy [J].
inline double
energy_of(const Particles& particles, const std::vector<DistanceConstraint>& constraints)
{
  double sum = 0;
  for (std::size_t i = 0; i < particles.positions.size(); ++i)
  {
    const double w = particles.inverse_masses[i];
    const double kinetic = particles.velocities[i].squaredNorm() / 2;
    sum += w > 0 ? (kinetic + 9.81 * particles.positions[i].y()) / w : 0;
  }
  for (const DistanceConstraint& one : constraints)
  {
    const double off = direction_of(particles, one).length - one.length;
    sum += one.compliance > 0 ? off * off / (2 * one.compliance) : 0;
  }
  return sum;
}

/// How much more [m] than the right sag a method lets the cable have, after 15 s in thick air.
inline double sag_error(const RopeMethod& method)
{
  Rope rope = cable(method.compliance);
  run_rope(rope, method, 900, 4, [](const Rope&) {});
  return lowest(rope) - sag_of_chain(40, 10, 8);
}

/// What fraction of its energy, from that at rest on, a swing from an angle has after each frame;
/// it ends where the rope explodes.
inline std::vector<double> swing_energies(const RopeMethod& method, double angle, int frames)
{
  Rope rope = swing(angle, method.compliance), hanging = swing(0, method.compliance);
  const double least = energy_of(hanging.particles, hanging.links);
  const double start = energy_of(rope.particles, rope.links) - least;
  std::vector<double> energies;
  try
  {
    run_rope(
        rope, method, frames, 0,
        [&](const Rope& now)
        { energies.push_back((energy_of(now.particles, now.links) - least) / start); });
  }
  catch (const std::invalid_argument&) // it has exploded
  {
    energies.push_back(std::numeric_limits<double>::infinity());
  }
  return energies;
}

/// How far [m] a rope is too long, after 15 s in thick air with a load [kg]; infinite where it
/// explodes.
///
/// A particle in its middle begins with a push [m/s] sideways.
inline double stretch_under(const RopeMethod& method, double load, double push = 0)
{
  Rope rope = loaded(load, method.compliance);
  rope.particles.velocities[10].x() = push;
  try
  {
    run_rope(rope, method, 900, 4, [](const Rope&) {});
  }
  catch (const std::invalid_argument&)
  {
    return std::numeric_limits<double>::infinity();
  }
  return -rope.particles.positions.back().y() - 5;
}

} // namespace cookbook
