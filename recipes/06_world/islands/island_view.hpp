#pragma once

/// \file
/// \brief What a solver of islands is given, and what it is called by.

#include "06_world/islands/island.hpp"
#include "06_world/islands/world_solver.hpp"

#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

struct SolverScratch;

// [island_view]
/// What a solver may see and change.
struct IslandView
{
  std::span<RigidBody> bodies;                    ///< all bodies of the world
  std::span<WorldContact> contacts;               ///< all contacts of the world
  Vector3<double> gravity;                        ///< [m/s²], world
  SolverScratch& scratch;                         ///< room
  std::span<const ExternalAcceleration> forces{}; ///< of this step, force_on()
  std::vector<bool>* falls = nullptr; ///< where given: of each body, whether nothing pushed it
  std::span<const ConstraintPair> constraints{}; ///< beside contacts, of all sets
  std::span<const ClonedSet> sets{};             ///< what these are of
};

/// The external acceleration of a body that is not fixed.
inline ExternalAcceleration acceleration_on(IslandView world, int body)
{
  return acceleration_on(world.gravity, world.forces, index_of(body));
}

/// Applies that for a time [s].
inline void apply_forces(IslandView world, int body, double time)
{
  apply_forces(world.bodies[index_of(body)], acceleration_on(world, body), time);
}

/// The separating acceleration [m/s²] of two bodies along a contact normal; negative: they press.
inline double separating_acceleration(IslandView world, const WorldContact& contact)
{
  const auto pulls = [&](int body)
  {
    const bool fixed = is_fixed(world.bodies[index_of(body)]);
    return fixed ? 0.0 : acceleration_on(world, body).acceleration.dot(contact.normal);
  };
  return pulls(contact.b) - pulls(contact.a);
}

/// A solver that solves islands one after the other; none if there is none for one.
inline WorldSolver one_by_one(IslandSolver solver)
{
  if (!solver)
  {
    return {};
  }
  return
      [solver = std::move(solver)](IslandView world, std::span<const Island> islands, double step)
  {
    for (const Island& island : islands)
    {
      solver(world, island, step);
    }
  };
}
// [island_view]

} // namespace cookbook
