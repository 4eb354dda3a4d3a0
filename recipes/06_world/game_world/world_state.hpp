#pragma once

/// \file
/// \brief What a world knows, and that it goes on by a step.

#include "01_math/turning/turn_between.hpp"
#include "06_world/contacts/broad_phase.hpp"
#include "06_world/impacts/impact.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/islands/past_body.hpp"
#include "06_world/sleeping/sleeping.hpp"
#include "06_world/sweeps/course.hpp"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

// What takes long to compile, step() and solver_named(), is compiled in every source that includes
// it; or once, if all sources are compiled with COOKBOOK_WORLD_COMPILED and one of them begins with
// #define COOKBOOK_WORLD_SOURCE.
#ifdef COOKBOOK_WORLD_COMPILED
#define COOKBOOK_WORLD_INLINE
#else
#define COOKBOOK_WORLD_INLINE inline
#endif
#if !defined(COOKBOOK_WORLD_COMPILED) || defined(COOKBOOK_WORLD_SOURCE)
#define COOKBOOK_WORLD_BODIES 1
#else
#define COOKBOOK_WORLD_BODIES 0
#endif

namespace cookbook
{

// [world_state]
/// All that a world knows; copied, it goes on as the original does.
struct WorldState
{
  Scene scene;                           ///< what the bodies are; as the last step began, after
                                         ///< its impacts
  bool may_sleep = false;                ///< whether bodies that rest fall asleep
  int balls = 0;                         ///< how many of those that are there
  long steps = 0;                        ///< since the start
  std::vector<RigidBody> bodies;         ///< in the order of the scene
  std::vector<Pull> forces;              ///< of the next step; none where nothing pulls
  std::vector<bool> gone;                ///< where nobody is any more
  std::vector<std::size_t> left;         ///< places of those taken out since the last step
  std::vector<std::size_t> free;         ///< places that may be given to others
  std::vector<bool> falls;               ///< who fell freely in the last step
  std::vector<bool> parted;              ///< who was moved out of an overlap, but not pushed
  std::vector<SleepState<double>> sleep; ///< who rests; empty if none may sleep
  std::vector<Bounds> bounds;            ///< of all that are there
  std::vector<Ahead> ahead;              ///< where each goes if nothing pushes it
  BroadPhase broad_phase;                ///< who may touch
  std::vector<WorldContact> contacts;    ///< of the last step
  std::vector<WorldContact> begun;       ///< those that began with it
  std::vector<Impact> impacts;           ///< of the last step
  Islands islands;                       ///< who hangs together
  std::vector<Island> touching;          ///< those that a step gives to the solver
  std::vector<IslandPoint> room;         ///< for the points of an island
  std::vector<Course> courses;           ///< room for those of a sweep
  std::vector<double> ways;              ///< [m], how far any point of a body went
  std::vector<bool> too_deep;            ///< whom a solver left too deep, or who is swept by now
};

/// Whether a body is there: it was put in, and not taken out.
inline bool is_there(const WorldState& world, BodyId id)
{
  const std::size_t place = place_in_lists(id);
  return place < world.bodies.size() && !world.gone[place] && id_at(world.bodies, place) == id;
}

/// What is thrown where a body is asked for that is not there.
inline std::out_of_range not_there(const WorldState& world, BodyId id)
{
  const std::size_t place = place_in_lists(id);
  const bool was_there = place < world.bodies.size() && id <= id_at(world.bodies, place);
  const std::string none = "there is no body " + std::to_string(id);
  return std::out_of_range(was_there ? none + " any more: it was taken out" : none);
}

/// Whether a body sleeps.
inline bool sleeps(const WorldState& world, int body)
{
  return world.may_sleep && world.sleep[place_of(body)].asleep;
}

/// Whether a body is left out, since it does not move.
inline bool is_still(const WorldState& world, int body)
{
  return is_fixed(world.bodies[place_of(body)]) || sleeps(world, body);
}

/// What pulls a body in the next step.
inline Pull pull_on(const WorldState& world, std::size_t i)
{
  return pull_on(world.scene.gravity, world.forces, i);
}

/// A body as the last step began.
inline PastBody start_of(const WorldState& world, std::size_t i)
{
  return start_of(world.scene.bodies[i]);
}

/// Watches whether a body rests, if any may sleep: what is pulled and falls freely does not, nor
/// what is moved out of an overlap, whatever its velocity.
inline void watch_rest(WorldState& world, std::size_t i)
{
  if (!world.may_sleep)
  {
    return;
  }
  const double step = world.scene.step;
  const RigidBody& body = world.bodies[i];
  const PastBody start = start_of(world, i);
  const auto larger = [](const Vector3<double>& one, const Vector3<double>& other)
  { return one.squaredNorm() > other.squaredNorm() ? one : other; };
  const Vector3<double> way = body.motion.center - start.motion.center;
  const Vector3<double> turn = turn_between<double>(start.orientation, body.orientation);
  const bool flies = world.falls[i] && !pull_on(world, i).acceleration.isZero(0);
  const double radius = bounds_of(body, world.scene.bodies[i].shape, 0).sizes().norm() / 2;
  const SleepState<double> before = flies ? SleepState<double>{} : world.sleep[i];
  world.sleep[i] = watched<double>(
      before, larger(body.motion.velocity, way / step),
      larger(body.motion.angular_velocity, turn / step), radius, step, SleepLimits<double>{});
}
// [world_state]

/// Goes on by one step of the scene.
COOKBOOK_WORLD_INLINE void step(WorldState& world, const WorldSolver& solver);

} // namespace cookbook
