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
/// Lists, contacts and impacts have a body at its place, which is its id until one is put in where
/// another was taken out; till then who was taken out stays in lists, fixed. What is asked of a
/// body that is not there, or not any more, is answered by std::out_of_range.
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
      enter(state_, state_.scene.bodies[bodies().size()]);
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
  /// Who hit whom in it, in the order of pairs; they may have been taken out since.
  const std::vector<Impact>& impacts() const { return state_.impacts; }
  double time() const { return double(state_.steps) * scene().step; } ///< [s], since the start
  /// Whether a body is there: it was put in, and not taken out.
  bool has(BodyId body) const { return is_there(state_, body); }
  /// The place of a body in lists.
  std::size_t place(BodyId body) const
  {
    if (!has(body))
    {
      throw not_there(state_, body);
    }
    return place_in_lists(body);
  }
  /// Who has a place, or had it last.
  BodyId id(std::size_t place) const
  {
    return place < bodies().size() ? id_at(bodies(), place) : throw not_there(state_, place);
  }
  const RigidBody& body(BodyId body) const { return bodies()[place(body)]; } ///< a body
  /// Whether a body sleeps.
  bool sleeps(BodyId body) const { return cookbook::sleeps(state_, static_cast<int>(place(body))); }

  /// How far apart [m] two bodies may be and still be in contact, but for impacts that are
  /// foreseen.
  double margin() const { return contact_margin(scene()); }

  /// Puts a body in, and says its id; InvalidScene, and nothing changes, if it makes no sense. What
  /// sleeps where it is put wakes.
  BodyId add(const SceneBody& body)
  {
    const std::size_t place = enter(state_, checked(body, next_place(state_)));
    wake_touched_by(state_, state_.bounds.back());
    return id(place);
  }

  /// Takes a body out: has() says so at once; from the next step on nothing touches it. What has
  /// leaned on it wakes. After that step its place is given to the next body that is put in.
  void remove(BodyId body) { leave(state_, place(body)); }

  /// Puts a body elsewhere [m], turned otherwise, world: what is on the way there is not hit, and
  /// nobody sees it go there. It keeps its velocity, and wakes with what it touched and what it
  /// will touch. InvalidShape, and nothing changes, if it is a plane or if that is no pose.
  void set_pose(BodyId body, const Vector3<double>& position, const Quaternion<double>& orientation)
  {
    check_can_be_put(scene().bodies[place(body)], position, orientation);
    put_elsewhere(state_, place(body), position, orientation);
  }

  /// Gives a body another velocity [m/s] and angular velocity [rad/s], world, and wakes it with all
  /// that hangs together with it. A fixed one stays as it is. InvalidShape, and nothing changes, if
  /// a number is not finite.
  void set_velocity(
      BodyId body, const Vector3<double>& velocity, const Vector3<double>& angular_velocity)
  {
    RigidBody& set = state_.bodies[place(body)];
    check_finite("velocity", velocity);
    check_finite("angular_velocity", angular_velocity);
    if (!is_fixed(set))
    {
      wake_island_of(body);
      set.motion = {set.motion.center, velocity, angular_velocity};
    }
  }

  /// Pulls a body in the next step, beside gravity, by an acceleration [m/s²] and an angular one
  /// [rad/s²], world, more; otherwise as set_velocity().
  void accelerate(BodyId body, const Vector3<double>& more, const Vector3<double>& angular_more)
  {
    const std::size_t i = place(body);
    Pull sum = force_on(state_.forces, i);
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

  /// Has two bodies pass through each other from the next step on, and wakes both; InvalidScene if
  /// they are one.
  void ignore(BodyId a, BodyId b)
  {
    std::vector<std::pair<int, int>>& ignored = state_.scene.ignored;
    const std::pair<int, int> pair = woken_pair(a, b);
    if (!ignores(scene(), pair))
    {
      ignored.insert(std::upper_bound(ignored.begin(), ignored.end(), pair), pair);
    }
  }

  /// Has two bodies meet again from the next step on, if they ignore each other, and wakes both;
  /// InvalidScene if they are one.
  void stop_ignoring(BodyId a, BodyId b) { std::erase(state_.scene.ignored, woken_pair(a, b)); }

  /// Goes on by one step of the scene. Where it throws TooManyContacts, all bodies are as before;
  /// forces are forgotten.
  void step() { cookbook::step(state_, solver_); }

private:
  /// Wakes a body and all that hangs together with it.
  void wake_island_of(BodyId body)
  {
    const int number = static_cast<int>(place(body));
    wake_islands_of(state_, {&number, 1});
  }

  /// The places of two bodies, the smaller one first; they wake. InvalidScene if they are one.
  std::pair<int, int> woken_pair(BodyId a, BodyId b)
  {
    const std::pair<int, int> pair =
        checked_pair({static_cast<int>(place(a)), static_cast<int>(place(b))}, bodies().size());
    wake_island_of(a);
    wake_island_of(b);
    return pair;
  }

  WorldSolver solver_;
  WorldState state_;
};
// [world]

} // namespace cookbook
