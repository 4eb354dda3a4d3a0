#pragma once

/// \file
/// \brief The constraints of an island beside its contacts, for solvers that go from one to the
/// next.

#include "06_world/islands/island_view.hpp"

#include <stdexcept>
#include <string>

namespace cookbook
{

// [island_constraints]
/// Calls `call(set, number)` for all constraints of an island, in their order.
template <class Call>
void each_constraint(IslandView world, const Island& island, const Call& call)
{
  for (const int i : island.constraints)
  {
    const ConstraintPair& pair = world.constraints[index_of(i)];
    call(*world.sets[pair.set], pair.number);
  }
}

/// Brings the matrices of bodies up to date that constraints push.
inline void update_joined_axes(IslandView world, const Island& island)
{
  for (const int i : island.constraints)
  {
    update_axes(world.bodies[index_of(world.constraints[index_of(i)].a)]);
    update_axes(world.bodies[index_of(world.constraints[index_of(i)].b)]);
  }
}

/// Begins a step of so many substeps.
inline void prepare_constraints(IslandView world, const Island& island, int substeps)
{
  each_constraint(
      world, island, [&](ConstraintSet& set, int number) { set.prepare(number, substeps); });
}

/// Pushes as the substep before has ended, with the bodies as they are before one [s].
inline void warm_start_constraints(IslandView world, const Island& island, double substep)
{
  each_constraint(
      world, island,
      [&](ConstraintSet& set, int number) { set.warm_start(world.bodies, number, substep); });
}

/// Corrects velocities once, one constraint after the other.
inline void
solve_constraints(IslandView world, const Island& island, const Softness<double>& softness)
{
  each_constraint(
      world, island,
      [&](ConstraintSet& set, int number) { set.solve(world.bodies, number, softness); });
}

/// Corrects velocities once where bodies have moved to.
inline void relax_constraints(IslandView world, const Island& island)
{
  each_constraint(
      world, island, [&](ConstraintSet& set, int number) { set.relax(world.bodies, number); });
}

/// Ends a step of so many substeps.
inline void store_constraints(IslandView world, const Island& island, int substeps)
{
  each_constraint(
      world, island, [&](ConstraintSet& set, int number) { set.store(number, substeps); });
}

/// Corrects poses once; std::logic_error where a kind of constraint cannot.
inline void correct_constraints(IslandView world, const Island& island)
{
  each_constraint(
      world, island,
      [&](ConstraintSet& set, int number)
      {
        if (!set.correct(world.bodies, number))
        {
          throw std::logic_error(
              std::string(set.name()) + " have no correct(): position_based cannot solve them");
        }
      });
}
// [island_constraints]

} // namespace cookbook
