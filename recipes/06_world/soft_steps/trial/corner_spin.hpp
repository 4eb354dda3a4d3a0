#pragma once

/// \file
/// \brief A cube that spins on its corner, and what stops it.

#include "01_math/rotations/rotation_between.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include <cmath>

namespace cookbook
{

// [corner_spin]
/// How fast [rad/s] the cube spins at first.
inline constexpr double corner_spin = 0.05;

/// A unit cube that stands on a corner and spins about the upright.
inline Scene cube_on_corner()
{
  Scene scene{.bodies = {ground(), cube_body("cube", {0, std::sqrt(0.75), 0})}};
  scene.bodies[1].orientation = rotation_between<double>({1, 1, 1}, {0, 1, 0});
  scene.bodies[1].angular_velocity = {0, corner_spin, 0};
  return scene;
}

/// When [s] it rests; at most 5.
inline double rests_after(const Scene& cube, const WorldSolver& solver)
{
  GameWorld world(cube, solver);
  while (world.time() < 5 && world.body(1).motion.angular_velocity.norm() > 1e-6)
  {
    world.step();
  }
  return world.time();
}

/// When [s] a moment μ m g r has stopped it, whose moment of inertia is m / 6; r is a fraction of
/// the arm, which is half the diagonal.
inline double rests_by_formula(double torsional_radius)
{
  const double radius = torsional_radius * std::sqrt(0.75);
  return corner_spin / (6 * 0.6 * 9.81 * radius);
}
// [corner_spin]

} // namespace cookbook
