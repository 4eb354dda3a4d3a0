#pragma once

/// \file
/// \brief What a world knows, and that it goes on by a step.

#include "06_world/game_world/world_module.hpp"
#include "06_world/impacts/hit_event.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/previous_state.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

// [world_state]
/// All that a world knows; copied, it goes on as the original does.
struct WorldState
{
  Scene scene;                              ///< what the bodies are; as the last step began, after
                                            ///< its impacts
  long steps = 0;                           ///< since the start
  std::vector<RigidBody> bodies;            ///< in the order of the scene
  std::vector<ExternalAcceleration> forces; ///< of the next step; none where nothing pulls
  std::vector<bool> removed;                ///< whether its body was removed
  std::vector<std::size_t> slots_to_free;   ///< places of those taken out since the last step
  std::vector<std::size_t> free_slots;      ///< places that may be given to others
  std::vector<bool> falls;                  ///< whether it fell freely in the last step
  std::vector<Bounds> bounds;               ///< of all that are there
  std::vector<WorldContact> contacts;       ///< of the last step
  std::vector<WorldContact> begun;          ///< those that began with it
  ContactChanges changes;                   ///< what is no longer there, of the last step
  std::vector<ClonedSet> sets;              ///< of constraints beside contacts, such as joints
  std::vector<ConstraintPair> constraints;  ///< of all sets, in their order
  Islands islands;                          ///< which bodies are solved together
  std::vector<Island> awake_islands;        ///< those that a step gives to the solver
  SolverScratch solver_scratch;             ///< room for islands that are solved
  Cloned<PairFinder> pair_finder{TreePairs()}; ///< which pairs may touch
  std::vector<Cloned<WorldModule>> modules;    ///< in the order in which a step calls them

  // What modules write, for others to read.
  bool finds_islands = false;   ///< by FindIslands: not all that is touched is one island
  std::vector<bool> asleep;     ///< by Sleeping; no entry: awake
  bool records_impacts = false; ///< by HitEvents: whether impacts are asked for
  std::vector<Impact> impacts;  ///< of the last step
};

/// Whether a body is there: it was put in, and not taken out.
inline bool is_valid(const WorldState& world, BodyId id)
{
  const std::size_t place = index_of_id(id);
  return place < world.bodies.size() && !world.removed[place] && id_at(world.bodies, place) == id;
}

/// What is thrown where a body is asked for that is not there.
inline std::out_of_range invalid_id(const WorldState& world, BodyId id)
{
  const std::size_t place = index_of_id(id);
  const bool was_there = place < world.bodies.size() && id <= id_at(world.bodies, place);
  const std::string none = "there is no body " + std::to_string(id);
  return std::out_of_range(was_there ? none + " any more: it was taken out" : none);
}

/// Whether a body sleeps.
inline bool is_asleep(const WorldState& world, int body)
{
  return index_of(body) < world.asleep.size() && world.asleep[index_of(body)];
}

/// Whether a body is left out, since it does not move.
inline bool is_inactive(const WorldState& world, int body)
{
  return stays(world.bodies[index_of(body)]) || is_asleep(world, body);
}

/// What pulls a body in the next step.
inline ExternalAcceleration acceleration_on(const WorldState& world, std::size_t i)
{
  return acceleration_on(world.scene.gravity, world.forces, i);
}

/// A body as the last step began.
inline PreviousState start_state(const WorldState& world, std::size_t i)
{
  return start_state(world.scene.bodies[i]);
}

/// Finds islands anew.
inline void find_islands(WorldState& world)
{
  world.islands.find(world.bodies, world.contacts, world.constraints, !world.finds_islands);
}

/// What solvers see of a world.
inline IslandView view_of(WorldState& world)
{
  return {world.bodies, world.contacts, world.scene.gravity, world.solver_scratch,
          world.forces, &world.falls,   world.constraints,   world.sets};
}

/// Calls `call(island)` for all islands that are awake, but of bodies alone.
template <class Call>
void each_awake_island(WorldState& world, const Call& call)
{
  for (std::size_t i = 0; i < world.islands.size(); ++i)
  {
    const Island island = world.islands[i];
    if (!is_alone(island) && !is_inactive(world, island.bodies.front()))
    {
      call(island);
    }
  }
}
// [world_state]

/// Goes on by one step of the scene.
inline void step(WorldState& world, const WorldSolver& solver);

} // namespace cookbook
