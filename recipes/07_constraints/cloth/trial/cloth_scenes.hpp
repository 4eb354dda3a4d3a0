#pragma once

/// \file
/// \brief Cloths on trial: a square that sags, a curtain, a flag, cloths that fall on things.

#include "07_constraints/cloth/cloth.hpp"
#include "common/math/trigonometry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace cookbook
{

// [cloth_scenes]
/// A square of 1 m and 200 g, level, held at its four corners; symmetric about the origin.
inline Cloth held_square(std::size_t particles = 16)
{
  Cloth cloth =
      make_cloth({.corner = {-0.5, 0, -0.5}, .columns = particles, .rows = particles, .mass = 0.2});
  const std::size_t last = particles - 1;
  for (const std::size_t corner :
       {cloth.at(0, 0), cloth.at(last, 0), cloth.at(0, last), cloth.at(last, last)})
  {
    cloth.particles.inverse_masses[corner] = 0;
  }
  return cloth;
}

/// A square of 1.6 m, level, half a metre above the origin.
inline Cloth falling_square(std::size_t particles = 20)
{
  return make_cloth(
      {.corner = {-0.8, 0.5, -0.8},
       .across = {1.6, 0, 0},
       .down = {0, 0, 1.6},
       .columns = particles,
       .rows = particles,
       .mass = 0.5,
       .shear = 1e-2,
       .bend = 1});
}

/// A flag of 1.5 m by 1 m, held by its first column.
inline Cloth flag()
{
  Cloth cloth = make_cloth(
      {.across = {1.5, 0, 0}, .down = {0, -1, 0}, .columns = 25, .rows = 17, .bend = 0.5});
  for (std::size_t row = 0; row < cloth.rows; ++row)
  {
    cloth.particles.inverse_masses[cloth.at(0, row)] = 0;
  }
  return cloth;
}

/// A curtain of 2 m by 1.6 m on a rail, in four pleats, that is drawn aside within a second: its
/// tie goes on with the velocities given here until `stop_tie`.
struct Curtain
{
  Cloth cloth;
  std::vector<std::size_t> tie; ///< particles

  /// Has the tie keep its place.
  void stop_tie()
  {
    for (const std::size_t i : tie)
    {
      cloth.particles.velocities[i] = {0, 0, 0};
    }
  }
};
// [cloth_scenes]

/// The pleated rail: each particle a thread's length on from the one before, along a wave.
inline std::vector<Vector3<double>> pleats(std::size_t count, double length)
{
  std::vector<Vector3<double>> rail{{-0.68, 0, 0}};
  for (std::size_t i = 1; i < count; ++i)
  {
    const double phase = (static_cast<double>(i) - 0.5) / 7 * 2 * std::numbers::pi;
    const SineCosine<double> heading = sine_cosine(1.2 * sine_cosine(phase).sine);
    const Vector3<double> along(heading.cosine, 0, heading.sine);
    rail.push_back(rail.back() + length * along);
  }
  return rail;
}

/// The curtain in its pleats, with a tie that is in its place within a second.
inline Curtain curtain()
{
  const double thread = 2.0 / 28;
  Curtain made{
      make_cloth(
          {.across = {2, 0, 0},
           .down = {0, -23 * thread, 0},
           .columns = 29,
           .rows = 24,
           .mass = 0.8,
           .shear = 3e-2,
           .bend = 0.3}),
      {}};
  Cloth& cloth = made.cloth;
  const std::vector<Vector3<double>> rail = pleats(cloth.columns, thread);
  for (std::size_t column = 0; column < cloth.columns; ++column)
  {
    for (std::size_t row = 0; row < cloth.rows; ++row)
    {
      const Vector3<double> down(0, -thread * static_cast<double>(row), 0);
      cloth.particles.positions[cloth.at(column, row)] = rail[column] + down;
    }
    // As far down the threads as it is from the rail to the tie.
    const Vector3<double> to(
        -0.62 + 0.12 * static_cast<double>(column) / 29, -0.9, 0.35 * rail[column].z());
    const double away = normalize<double>(to - rail[column]).length;
    const std::size_t row = static_cast<std::size_t>(1.02 * away / thread) + 1;
    const std::size_t tied = cloth.at(column, std::min(row, cloth.rows - 1));
    cloth.particles.inverse_masses[cloth.at(column, 0)] = 0;
    cloth.particles.inverse_masses[tied] = 0;
    cloth.particles.velocities[tied] = to - cloth.particles.positions[tied]; // within a second
    made.tie.push_back(tied);
  }
  return made;
}

/// Moves a cloth on by frames.
inline void run_cloth(
    Cloth& cloth, int frames, const StepSettings& settings, const Obstacles& obstacles = {},
    const Air& air = {})
{
  for (int frame = 0; frame < frames; ++frame)
  {
    step_cloth(cloth, settings, obstacles, air);
  }
}

/// The largest stretch along the threads of a cloth, as a fraction of their length.
inline double worst_thread(const Cloth& cloth)
{
  double most = 0;
  for (const DistanceConstraint& pair : cloth.constraints)
  {
    const double length = direction_of(cloth.particles, pair).length;
    most = pair.compliance == 0 ? std::max(most, length / pair.length - 1) : most;
  }
  return most;
}

/// The area of a cloth [m²].
inline double area_of(const Cloth& cloth)
{
  const auto& x = cloth.particles.positions;
  double area = 0;
  for (const auto& [a, b, c] : cloth.triangles)
  {
    area += (x[b] - x[a]).cross(x[c] - x[a]).norm() / 2;
  }
  return area;
}

/// Kinetic, potential and elastic energy of a cloth [J].
inline double energy_of(const Cloth& cloth)
{
  double sum = 0;
  for (std::size_t i = 0; i < cloth.particles.positions.size(); ++i)
  {
    const double w = cloth.particles.inverse_masses[i];
    const double kinetic = cloth.particles.velocities[i].squaredNorm() / 2;
    sum += w > 0 ? (kinetic + 9.81 * cloth.particles.positions[i].y()) / w : 0;
  }
  for (const DistanceConstraint& pair : cloth.constraints)
  {
    const double off = direction_of(cloth.particles, pair).length - pair.length;
    sum += pair.compliance > 0 ? off * off / (2 * pair.compliance) : 0;
  }
  return sum;
}

} // namespace cookbook
