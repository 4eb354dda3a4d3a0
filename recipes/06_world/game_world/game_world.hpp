#pragma once

/// \file
/// \brief A world of bodies that fall, meet, bounce and rest, for a game.

#include "06_world/game_world/world_bodies.hpp"
#include "06_world/game_world/world_checks.hpp"
#include "06_world/game_world/world_state.hpp"
#if COOKBOOK_WORLD_BODIES
#include "06_world/game_world/world_step.hpp"
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace cookbook
{

// [world]
/// Bodies in motion, from a scene that makes sense. No body of it becomes NaN or infinite. A copy
/// goes on as the original would, to the bit.
/// Bodies are known by ids; those of the scene are 0, 1, 2, … An id is never given to another body.
/// Lists, contacts and impacts have a body at its index, which is its id until a slot is reused; a
/// removed body stays in its slot, fixed. An id that is not valid throws std::out_of_range.
class GameWorld
{
public:
  /// The scene as it starts; InvalidScene if it makes no sense, or if there is no solver.
  GameWorld(const Scene& scene, WorldSolver solver, bool may_sleep = false)
      : solver_(std::move(solver))
  {
    if (!solver_)
    {
      throw InvalidScene("a world needs a solver, such as solver_named(\"direct\") of solvers.hpp");
    }
    state_.scene = checked(scene);
    state_.may_sleep = may_sleep;
    state_.bodies.reserve(scene.bodies.size());
    state_.bounds.reserve(scene.bodies.size());
    while (bodies().size() < state_.scene.bodies.size())
    {
      add_body(state_, state_.scene.bodies[bodies().size()]);
    }
  }

  /// The same with a solver of one island, an IslandSolver.
  template <class Solver>
  requires std::is_invocable_v<Solver&, IslandView, const Island&, double>
  GameWorld(const Scene& scene, Solver solver, bool may_sleep = false)
      : GameWorld(scene, one_by_one(std::move(solver)), may_sleep)
  {
  }

  /// What the bodies are, and how they were as the last step began, after its impacts; those put in
  /// or elsewhere since as they were put; also those taken out until others have their places.
  const Scene& scene() const { return state_.scene; }
  const std::vector<RigidBody>& bodies() const { return state_.bodies; } ///< in its order, as now
  /// All contacts of the last step.
  const std::vector<WorldContact>& contacts() const { return state_.contacts; }
  /// The hit events of that step, in the order of pairs; bodies may have been removed since.
  const std::vector<Impact>& impacts() const { return state_.impacts; }
  double time() const { return double(state_.steps) * scene().step; } ///< [s], since the start
  /// Whether an id is valid: the body was added, and not removed.
  bool has(BodyId body) const { return is_valid(state_, body); }
  /// The index of a body in lists.
  std::size_t index(BodyId body) const
  {
    if (!has(body))
    {
      throw invalid_id(state_, body);
    }
    return index_of_id(body);
  }
  /// The id of the body in a slot, or of the last one there.
  BodyId id(std::size_t place) const
  {
    return place < bodies().size() ? id_at(bodies(), place) : throw invalid_id(state_, place);
  }
  const RigidBody& body(BodyId body) const { return bodies()[index(body)]; } ///< a body
  /// Whether a body sleeps.
  bool is_asleep(BodyId body) const
  {
    return cookbook::is_asleep(state_, static_cast<int>(index(body)));
  }

  /// How far apart [m] two bodies may be and still be in contact, speculative contacts excepted.
  double margin() const { return contact_margin(scene()); }

  /// Adds a body and returns its id; InvalidScene, and nothing changes, if it makes no sense.
  /// Bodies that sleep where it is put wake.
  BodyId add(const SceneBody& body)
  {
    const std::size_t place = add_body(state_, checked(body, next_index(state_)));
    wake_touched_by(state_, state_.bounds.back());
    return id(place);
  }

  /// Removes a body, and wakes what touches it; after the next step its slot is free.
  void remove(BodyId body) { remove_body(state_, index(body)); }

  /// Teleports a body to a pose [m], world; it hits nothing in between and keeps its velocity. It
  /// wakes, with what it touched and what it will touch. InvalidShape, and nothing changes, if it
  /// is a plane or if that is no pose.
  void set_pose(BodyId body, const Vector3<double>& position, const Quaternion<double>& orientation)
  {
    check_can_teleport(scene().bodies[index(body)], position, orientation);
    teleport(state_, index(body), position, orientation);
  }

  /// Gives a body another velocity [m/s] and angular velocity [rad/s], world, and wakes it with all
  /// that hangs together with it. A kinematic one goes on with it until it is given another; a
  /// fixed one stays as it is. InvalidShape, and nothing changes, if a number is not finite.
  void set_velocity(
      BodyId body, const Vector3<double>& velocity, const Vector3<double>& angular_velocity)
  {
    RigidBody& set = state_.bodies[index(body)];
    check_finite("velocity", velocity);
    check_finite("angular_velocity", angular_velocity);
    if (set.motion_type != MotionType::fixed)
    {
      wake_island_of(body);
      set.motion = {set.motion.center, velocity, angular_velocity};
    }
  }

  /// Pulls a body in the next step, beside gravity, by an acceleration [m/s²] and an angular one
  /// [rad/s²], world, more; otherwise as set_velocity(), but a kinematic one stays as it is, too.
  void accelerate(BodyId body, const Vector3<double>& more, const Vector3<double>& angular_more)
  {
    const std::size_t i = index(body);
    ExternalAcceleration sum = force_on(state_.forces, i);
    check_finite("acceleration", sum.acceleration += more);
    check_finite("angular_acceleration", sum.angular_acceleration += angular_more);
    if (!is_fixed(state_.bodies[i]))
    {
      wake_island_of(body);
      state_.forces.resize(state_.bodies.size());
      state_.forces[i] = sum;
    }
  }

  /// Pulls all bodies by another gravity [m/s²], world, from the next step on; they wake, unless it
  /// is the same. InvalidShape, and nothing changes, if it is not finite.
  void set_gravity(const Vector3<double>& gravity)
  {
    check_finite("gravity", gravity);
    if (gravity != scene().gravity)
    {
      state_.scene.gravity = gravity;
      state_.sleep.assign(state_.sleep.size(), {});
    }
  }

  /// Turns collisions of two bodies off, and wakes both; InvalidScene if they are one.
  void ignore(BodyId a, BodyId b)
  {
    std::vector<std::pair<int, int>>& ignored = state_.scene.ignored;
    const std::pair<int, int> pair = woken_pair(a, b);
    if (!ignores(scene(), pair))
    {
      ignored.insert(std::upper_bound(ignored.begin(), ignored.end(), pair), pair);
    }
  }

  /// Turns them on again, and wakes both; InvalidScene if they are one.
  void stop_ignoring(BodyId a, BodyId b) { std::erase(state_.scene.ignored, woken_pair(a, b)); }

  /// Goes on by one step of the scene. Where it throws TooManyContacts, all bodies are as before;
  /// forces are forgotten.
  void step() { cookbook::step(state_, solver_); }

private:
  /// Wakes a body and all that hangs together with it.
  void wake_island_of(BodyId body)
  {
    const int number = static_cast<int>(index(body));
    wake_islands_of(state_, {&number, 1});
  }

  /// The places of two bodies, the smaller one first; they wake. InvalidScene if they are one.
  std::pair<int, int> woken_pair(BodyId a, BodyId b)
  {
    const std::pair<int, int> pair =
        checked_pair({static_cast<int>(index(a)), static_cast<int>(index(b))}, bodies().size());
    wake_island_of(a);
    wake_island_of(b);
    return pair;
  }

  WorldSolver solver_;
  WorldState state_;
};
// [world]

} // namespace cookbook
