#pragma once

/// \file
/// \brief Wind on the triangles of a cloth.

#include "07_constraints/particles/particles.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace cookbook
{

// [apply_wind]
/// Changes the velocities of a triangle's particles by the wind, for a substep h [s]: a pressure
/// along its normal, ½ ρ c |n·u| n·u, where u [m/s] is the air's velocity past the triangle; R48.
///
/// `density`, ρ c [kg/m³], is that of the air times the drag coefficient. The speed along n at the
/// end of the substep counts, so that no wind is too strong. A triangle without area has no force.
inline void apply_wind(
    Particles& particles, const std::array<std::size_t, 3>& triangle, const Vector3<double>& wind,
    double density, double h)
{
  const auto [a, b, c] = triangle;
  const auto& x = particles.positions;
  auto& v = particles.velocities;
  const auto& w = particles.inverse_masses;
  const Direction<double> n = normalize<double>((x[b] - x[a]).cross(x[c] - x[a]));
  const double area = n.length / 2;
  const double past = n.unit.dot(wind - (v[a] + v[b] + v[c]) / 3);
  const double drag = h * density / 2 * area * std::abs(past);
  const Vector3<double> impulse = drag * past / (1 + drag * (w[a] + w[b] + w[c])) * n.unit;
  v[a] += w[a] / 3 * impulse;
  v[b] += w[b] / 3 * impulse;
  v[c] += w[c] / 3 * impulse;
}
// [apply_wind]

} // namespace cookbook
