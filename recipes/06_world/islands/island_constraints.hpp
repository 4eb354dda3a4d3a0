#pragma once

/// \file
/// \brief The constraints of an island beside its contacts, for solvers that go from one to the
/// next.

#include "06_world/contacts/integrate_body.hpp"
#include "06_world/islands/island_view.hpp"

#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

/// The kinematic bodies in motion that an island touches or hangs on.
inline std::set<int> driven_bodies(IslandView world, const Island& island)
{
  std::set<int> driven;
  for (const int number : island.contacts)
  {
    const WorldContact& contact = world.contacts[index_of(number)];
    driven.insert({contact.a, contact.b});
  }
  for (const int number : island.constraints)
  {
    const ConstraintPair& pair = world.constraints[index_of(number)];
    driven.insert({pair.a, pair.b});
  }
  std::erase_if(driven, [&](int i) { return !is_driven(world.bodies[index_of(i)]); });
  return driven;
}

/// Has kinematic bodies of an island go along in substeps, and back in the end: they may be of
/// other islands too, and the world moves them when the step ends.
class DrivenAlong
{
public:
  DrivenAlong(IslandView world, const Island& island) : world_(world)
  {
    for (const int i : driven_bodies(world, island))
    {
      driven_.emplace_back(i, world.bodies[index_of(i)]);
    }
  }
  ~DrivenAlong()
  {
    for (const auto& [body, start] : driven_)
    {
      world_.bodies[index_of(body)] = start;
    }
  }
  DrivenAlong(const DrivenAlong&) = delete;
  DrivenAlong& operator=(const DrivenAlong&) = delete;

  /// Moves them on by a substep [s].
  void move(double substep)
  {
    for (const auto& [body, start] : driven_)
    {
      integrate_position(world_.bodies[index_of(body)], substep);
    }
  }

private:
  IslandView world_;
  std::vector<std::pair<int, RigidBody>> driven_; // as they are before the step
};

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

/// Corrects poses once after a substep [s]; std::logic_error where a kind of constraint cannot.
inline void correct_constraints(IslandView world, const Island& island, double substep, bool first)
{
  each_constraint(
      world, island,
      [&](ConstraintSet& set, int number)
      {
        if (!set.correct(world.bodies, number, substep, first))
        {
          throw std::logic_error(
              std::string(set.name()) + " have no correct(): position_based cannot solve them");
        }
      });
}
// [island_constraints]

} // namespace cookbook
