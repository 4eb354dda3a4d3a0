#pragma once

/// \file
/// \brief A world of bodies that fall, meet, bounce and rest, for a game.

#include "06_world/contacts/too_many_contacts.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/game_world/compiled_once.hpp"
#include "06_world/game_world/invalid_scene.hpp"
#include "06_world/impacts/hit_event.hpp"
#include "06_world/islands/world_solver.hpp"

#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace cookbook
{

struct WorldModules;
class ConstraintSet;

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
  GameWorld(const Scene& scene, WorldSolver solver, bool may_sleep = false);

  /// The same with these modules around the solver, instead of all of game_modules().
  GameWorld(const Scene& scene, WorldSolver solver, WorldModules modules);

  /// The same with a solver of one island, an IslandSolver.
  template <class Solver>
  requires(!std::same_as<Solver, WorldSolver>) &&
      std::is_invocable_v<Solver&, IslandView, const Island&, double> GameWorld(
          const Scene& scene, Solver solver, bool may_sleep = false)
      : GameWorld(scene, one_by_one(std::move(solver)), may_sleep)
  {
  }

  GameWorld(const GameWorld& other);
  GameWorld(GameWorld&& other) noexcept;
  GameWorld& operator=(const GameWorld& other);
  GameWorld& operator=(GameWorld&& other) noexcept;
  ~GameWorld();

  /// What the bodies are, and how they were as the last step began, after its impacts; those put in
  /// or elsewhere since as they were put; also those taken out until others have their places.
  const Scene& scene() const;
  const std::vector<RigidBody>& bodies() const; ///< in its order, as now
  /// All contacts of the last step.
  const std::vector<WorldContact>& contacts() const;
  /// The hit events of that step, in the order of pairs; bodies may have been removed since.
  const std::vector<Impact>& impacts() const;
  double time() const; ///< [s], since the start
  /// Whether an id is valid: the body was added, and not removed.
  bool has(BodyId body) const;
  /// The index of a body in lists.
  std::size_t index(BodyId body) const;
  /// The id of the body in a slot, or of the last one there.
  BodyId id(std::size_t place) const;
  const RigidBody& body(BodyId body) const; ///< a body
  /// Whether a body sleeps.
  bool is_asleep(BodyId body) const;

  /// How far apart [m] two bodies may be and still be in contact, speculative contacts excepted.
  double margin() const;

  /// Adds a body and returns its id; InvalidScene, and nothing changes, if it makes no sense.
  /// Bodies that sleep where it is put wake.
  BodyId add(const SceneBody& body);

  /// Adds a set of constraints, such as ball joints, and returns its place among all; their bodies
  /// wake. Bodies of a pair that does not touch are ignored as by ignore(), until stop_ignoring().
  /// Nothing changes, but std::out_of_range is thrown, where one is of a body that is not there,
  /// and InvalidScene where one joins a body with itself. The constraints of a body that is removed
  /// are dropped.
  std::size_t add(const ConstraintSet& set);
  std::size_t constraint_sets() const; ///< how many sets there are
  /// A set by its place, to be read or changed; std::out_of_range where there is none.
  ConstraintSet& constraint_set(std::size_t place);
  /// The same of a kind; std::bad_cast where it is of another.
  template <class Set>
  Set& constraints(std::size_t place)
  {
    return dynamic_cast<Set&>(constraint_set(place));
  }

  /// Removes a body, and wakes what touches it; after the next step its slot is free.
  void remove(BodyId body);

  /// Teleports a body to a pose [m], world; it hits nothing in between and keeps its velocity. It
  /// wakes, with what it touched and what it will touch. InvalidShape, and nothing changes, if it
  /// is a plane or if that is no pose.
  void
  set_pose(BodyId body, const Vector3<double>& position, const Quaternion<double>& orientation);

  /// Gives a body another velocity [m/s] and angular velocity [rad/s], world, and wakes it with all
  /// that hangs together with it. A kinematic one goes on with it until it is given another; a
  /// fixed one stays as it is. InvalidShape, and nothing changes, if a number is not finite.
  void set_velocity(
      BodyId body, const Vector3<double>& velocity, const Vector3<double>& angular_velocity);

  /// Pulls a body in the next step, beside gravity, by an acceleration [m/s²] and an angular one
  /// [rad/s²], world, more; otherwise as set_velocity(), but a kinematic one stays as it is, too.
  void accelerate(BodyId body, const Vector3<double>& more, const Vector3<double>& angular_more);

  /// Pulls all bodies by another gravity [m/s²], world, from the next step on; they wake, unless it
  /// is the same. InvalidShape, and nothing changes, if it is not finite.
  void set_gravity(const Vector3<double>& gravity);

  /// Turns collisions of two bodies off, and wakes both; InvalidScene if they are one.
  void ignore(BodyId a, BodyId b);

  /// Turns them on again, and wakes both; InvalidScene if they are one.
  void stop_ignoring(BodyId a, BodyId b);

  /// Goes on by one step of the scene. Where it throws TooManyContacts, all bodies are as before;
  /// forces are forgotten.
  void step();

private:
  struct Inside;

  void wake_island_of(BodyId body);
  std::pair<int, int> woken_pair(BodyId a, BodyId b);

  std::unique_ptr<Inside> inside_; // so that a game compiles no more than this
};
// [world]

} // namespace cookbook

#if COOKBOOK_WORLD_BODIES
#include "06_world/game_world/world_calls.hpp"
#endif
