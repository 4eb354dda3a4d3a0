#pragma once

/// \file
/// \brief What a world knows, and that it goes on by a step.

#include "01_math/turning/turn_between.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/impacts/impact.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/previous_state.hpp"
#include "06_world/seams/seams.hpp"
#include "06_world/sleeping/sleeping.hpp"
#include "06_world/sweeps/trajectory.hpp"

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
  bool may_sleep = false;                   ///< whether bodies that rest fall asleep
  int spheres = 0;                          ///< how many of those that are there
  long steps = 0;                           ///< since the start
  std::vector<RigidBody> bodies;            ///< in the order of the scene
  std::vector<ExternalAcceleration> forces; ///< of the next step; none where nothing pulls
  std::vector<bool> removed;                ///< whether its body was removed
  std::vector<std::size_t> slots_to_free;   ///< places of those taken out since the last step
  std::vector<std::size_t> free_slots;      ///< places that may be given to others
  std::vector<bool> falls;                  ///< whether it fell freely in the last step
  std::vector<SleepState<double>> sleep;    ///< whether it rests; empty if none may sleep
  std::vector<Bounds> bounds;               ///< of all that are there
  std::vector<Prediction> prediction;       ///< where each goes if nothing pushes it
  BroadPhase broad_phase;                   ///< which pairs may touch
  std::vector<WorldContact> contacts;       ///< of the last step
  std::vector<WorldContact> begun;          ///< those that began with it
  Seams seams;                              ///< scratch, for bodies on flush tiles
  std::vector<Impact> impacts;              ///< of the last step
  std::vector<ClonedSet> sets;              ///< of constraints beside contacts, such as joints
  std::vector<ConstraintPair> constraints;  ///< of all sets, in their order
  Islands islands;                          ///< which bodies are connected by contacts
  std::vector<Island> awake_islands;        ///< those that a step gives to the solver
  SolverScratch solver_scratch;             ///< room for islands that are solved
  std::vector<Trajectory> trajectories;     ///< room for those of a sweep
  std::vector<double> displacements;        ///< [m], how far any point of a body went
  std::vector<bool> needs_sweep;            ///< left too deep by a solver, or swept
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
  return world.may_sleep && world.sleep[index_of(body)].asleep;
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

/// Watches whether a body rests, if any may sleep: what is pulled and falls freely does not, nor
/// what is moved out of an overlap, whatever its velocity. Damps what nearly rests.
inline void update_sleep_timer(WorldState& world, std::size_t i)
{
  if (!world.may_sleep)
  {
    return;
  }
  const double step = world.scene.step;
  RigidBody& body = world.bodies[i];
  const PreviousState start = start_state(world, i);
  const auto larger = [](const Vector3<double>& one, const Vector3<double>& other)
  { return one.squaredNorm() > other.squaredNorm() ? one : other; };
  const Vector3<double> displacement = body.motion.center - start.motion.center;
  const Vector3<double> turn = turn_between<double>(start.orientation, body.orientation);
  const bool falls = world.falls[i] && !acceleration_on(world, i).acceleration.isZero(0);
  const double radius = bounds_of(body, world.scene.bodies[i].shape, 0).sizes().norm() / 2;
  if (!world.falls[i])
  {
    const double slower = rest_damping<double>(
        body.motion.velocity, body.motion.angular_velocity, radius, step, SleepLimits<double>{});
    body.motion.velocity *= slower;
    body.motion.angular_velocity *= slower;
  }
  const SleepState<double> before = falls ? SleepState<double>{} : world.sleep[i];
  world.sleep[i] = update_sleep_state<double>(
      before, larger(body.motion.velocity, displacement / step),
      larger(body.motion.angular_velocity, turn / step), radius, step, SleepLimits<double>{});
}
// [world_state]

/// Goes on by one step of the scene.
inline void step(WorldState& world, const WorldSolver& solver);

} // namespace cookbook
