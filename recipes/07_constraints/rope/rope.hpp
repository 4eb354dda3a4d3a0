#pragma once

/// \file
/// \brief A rope of particles, and four methods that move it: springs, implicit springs, XPBD, and
/// all links at once.

#include "07_constraints/particles/xpbd.hpp"
#include "07_constraints/rope/direct_rope.hpp"
#include "07_constraints/rope/implicit_springs.hpp"
#include "07_constraints/rope/mass_spring.hpp"

#include <cstddef>
#include <vector>

namespace cookbook
{

// [rope]
/// Particles, and the constraints between them.
struct Rope
{
  Particles particles;
  std::vector<DistanceConstraint> links; ///< link i joins particles i and i+1
};

/// A rope of a mass [kg], straight from `start` to `end` [m], at rest and free at both ends; its
/// links are as long as they are drawn, with a compliance each [m/N].
///
/// Throws std::invalid_argument, with member and value, where a number is not finite or makes no
/// sense.
inline Rope make_rope(
    const Vector3<double>& start, const Vector3<double>& end, std::size_t links, double mass,
    double compliance = 0)
{
  check_setting("links", static_cast<double>(links), 1, 1e6);
  check_setting("mass", mass, 1e-9, largest_number);
  Rope rope;
  const double count = static_cast<double>(links);
  const double length = normalize<double>(end - start).length / count;
  for (std::size_t i = 0; i <= links; ++i)
  {
    const double t = static_cast<double>(i) / count;
    rope.particles.positions.push_back((1 - t) * start + t * end);
    rope.particles.velocities.push_back({0, 0, 0});
    rope.particles.inverse_masses.push_back(count / mass);
  }
  for (std::size_t i = 0; i < links; ++i)
  {
    rope.links.push_back({i, i + 1, length, compliance});
  }
  check(rope.particles);
  check(rope.links, links + 1);
  return rope;
}
// [rope]

} // namespace cookbook
