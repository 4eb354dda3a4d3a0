#pragma once

/// \file
/// \brief Overlaps that the direct solver opens, without leaving the speed with which they open.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/direct_solver/direct_solver.hpp"
#include "06_world/islands/island_points.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

// [open_overlaps]
/// Solves an island, of which these are the motions before a step [s], once more, without the speed
/// that opens overlaps, friction bounded by what pushed in the first answer. The island moves on by
/// the first and keeps the velocities of the second, if there is one, so that no body is shot out
/// of an overlap.
inline void open_overlaps(
    DirectSolver& solver, IslandView world, const Island& island, double step,
    std::vector<Motion<double>>& motions)
{
  const auto swap_motions = [&]
  {
    for (std::size_t i = 0; i < motions.size(); ++i)
    {
      std::swap(world.bodies[index_of(island.bodies[i])].motion, motions[i]);
    }
  };
  swap_motions();
  const bool found = solver.solve(
      world, island, step, {.correction = 0, .residual = solver.small(), .bounds_move = false});
  swap_motions();
  for (std::size_t i = 0; i < motions.size(); ++i)
  {
    RigidBody& body = world.bodies[index_of(island.bodies[i])];
    const Motion<double>& end = found ? motions[i] : body.motion;
    const Vector3<double> change = end.velocity - body.motion.velocity;
    const Vector3<double> turn = world_inertia(body.moments, body.axes) *
                                 (end.angular_velocity - body.motion.angular_velocity);
    integrate_position(body, step);
    body.motion.velocity += change;
    body.motion.angular_velocity += body.inverse_inertia * turn;
  }
}
// [open_overlaps]

} // namespace cookbook
