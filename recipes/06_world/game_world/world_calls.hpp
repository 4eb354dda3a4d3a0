#pragma once

/// \file
/// \brief What a world answers to a game, which is checked first.

#include "06_world/game_world/game_modules.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/world_bodies.hpp"
#include "06_world/game_world/world_checks.hpp"
#include "06_world/game_world/world_step.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

// [world_calls]
/// What a world holds.
struct GameWorld::Inside
{
  WorldSolver solver;
  WorldState state{};
};

/// Adds a set of a scene, or throws InvalidScene.
inline void add_checked(GameWorld& world, const std::shared_ptr<const ConstraintSet>& set)
{
  if (!set)
  {
    throw InvalidScene("scene: one of constraints is null");
  }
  try
  {
    world.add(*set);
  }
  catch (const std::out_of_range& wrong)
  {
    throw InvalidScene(
        std::string("scene: ").append(set->name()).append(": ").append(wrong.what()));
  }
}

COOKBOOK_WORLD_INLINE
GameWorld::GameWorld(const Scene& scene, WorldSolver solver, bool may_sleep)
    : GameWorld(scene, std::move(solver), game_modules(may_sleep))
{
}

COOKBOOK_WORLD_INLINE
GameWorld::GameWorld(const Scene& scene, WorldSolver solver, WorldModules modules)
    : inside_(std::make_unique<Inside>(Inside{std::move(solver)}))
{
  if (!inside_->solver)
  {
    throw InvalidScene("a world needs a solver, such as solver_named(\"direct\") of solvers.hpp");
  }
  WorldState& state = inside_->state;
  state.scene = checked(scene);
  state.modules = std::move(modules.list);
  state.pair_finder = std::move(modules.pair_finder);
  for (const Cloned<WorldModule>& module : state.modules)
  {
    module->added(state);
  }
  state.bodies.reserve(scene.bodies.size());
  state.bounds.reserve(scene.bodies.size());
  while (state.bodies.size() < state.scene.bodies.size())
  {
    add_body(state, state.scene.bodies[state.bodies.size()]);
  }
  state.scene.constraints.clear(); // the world has copies, which go on
  for (const std::shared_ptr<const ConstraintSet>& set : scene.constraints)
  {
    add_checked(*this, set);
  }
}

COOKBOOK_WORLD_INLINE GameWorld::GameWorld(const GameWorld& other)
    : inside_(std::make_unique<Inside>(*other.inside_))
{
}

COOKBOOK_WORLD_INLINE GameWorld& GameWorld::operator=(const GameWorld& other)
{
  return *this = GameWorld(other);
}

COOKBOOK_WORLD_INLINE GameWorld::GameWorld(GameWorld&& other) noexcept = default;
COOKBOOK_WORLD_INLINE GameWorld& GameWorld::operator=(GameWorld&& other) noexcept = default;
COOKBOOK_WORLD_INLINE GameWorld::~GameWorld() = default;

COOKBOOK_WORLD_INLINE const Scene& GameWorld::scene() const
{
  return inside_->state.scene;
}

COOKBOOK_WORLD_INLINE const std::vector<RigidBody>& GameWorld::bodies() const
{
  return inside_->state.bodies;
}

COOKBOOK_WORLD_INLINE const std::vector<WorldContact>& GameWorld::contacts() const
{
  return inside_->state.contacts;
}

COOKBOOK_WORLD_INLINE const std::vector<Impact>& GameWorld::impacts() const
{
  return inside_->state.impacts;
}

COOKBOOK_WORLD_INLINE double GameWorld::time() const
{
  return double(inside_->state.steps) * scene().step;
}

COOKBOOK_WORLD_INLINE bool GameWorld::has(BodyId body) const
{
  return is_valid(inside_->state, body);
}

COOKBOOK_WORLD_INLINE std::size_t GameWorld::index(BodyId body) const
{
  if (!has(body))
  {
    throw invalid_id(inside_->state, body);
  }
  return index_of_id(body);
}

COOKBOOK_WORLD_INLINE BodyId GameWorld::id(std::size_t place) const
{
  return place < bodies().size() ? id_at(bodies(), place) : throw invalid_id(inside_->state, place);
}

COOKBOOK_WORLD_INLINE const RigidBody& GameWorld::body(BodyId body) const
{
  return bodies()[index(body)];
}

COOKBOOK_WORLD_INLINE bool GameWorld::is_asleep(BodyId body) const
{
  return cookbook::is_asleep(inside_->state, static_cast<int>(index(body)));
}

COOKBOOK_WORLD_INLINE double GameWorld::margin() const
{
  return contact_margin(scene());
}

COOKBOOK_WORLD_INLINE BodyId GameWorld::add(const SceneBody& body)
{
  WorldState& state = inside_->state;
  const std::size_t place = add_body(state, checked(body, next_index(state)));
  wake_touched_by(state, state.bounds.back());
  return id(place);
}

COOKBOOK_WORLD_INLINE std::size_t GameWorld::add(const ConstraintSet& set)
{
  WorldState with = inside_->state;
  with.sets.emplace_back(set);
  find_constraints(with);
  inside_->state = std::move(with);
  wake_joined(inside_->state, inside_->state.sets.size() - 1);
  return inside_->state.sets.size() - 1;
}

COOKBOOK_WORLD_INLINE std::size_t GameWorld::constraint_sets() const
{
  return inside_->state.sets.size();
}

COOKBOOK_WORLD_INLINE ConstraintSet& GameWorld::constraint_set(std::size_t place)
{
  return *inside_->state.sets.at(place);
}

COOKBOOK_WORLD_INLINE void GameWorld::remove(BodyId body)
{
  remove_body(inside_->state, index(body));
}

COOKBOOK_WORLD_INLINE void GameWorld::set_pose(
    BodyId body, const Vector3<double>& position, const Quaternion<double>& orientation)
{
  check_can_teleport(scene().bodies[index(body)], position, orientation);
  teleport(inside_->state, index(body), position, orientation);
}

COOKBOOK_WORLD_INLINE void GameWorld::set_velocity(
    BodyId body, const Vector3<double>& velocity, const Vector3<double>& angular_velocity)
{
  RigidBody& set = inside_->state.bodies[index(body)];
  check_finite("velocity", velocity);
  check_finite("angular_velocity", angular_velocity);
  if (set.motion_type != MotionType::fixed)
  {
    wake_island_of(body);
    set.motion = {set.motion.center, velocity, angular_velocity};
  }
}

COOKBOOK_WORLD_INLINE void
GameWorld::accelerate(BodyId body, const Vector3<double>& more, const Vector3<double>& angular_more)
{
  WorldState& state = inside_->state;
  const std::size_t i = index(body);
  ExternalAcceleration sum = force_on(state.forces, i);
  check_finite("acceleration", sum.acceleration += more);
  check_finite("angular_acceleration", sum.angular_acceleration += angular_more);
  if (!is_fixed(state.bodies[i]))
  {
    wake_island_of(body);
    state.forces.resize(state.bodies.size());
    state.forces[i] = sum;
  }
}

COOKBOOK_WORLD_INLINE void GameWorld::set_gravity(const Vector3<double>& gravity)
{
  check_finite("gravity", gravity);
  WorldState& state = inside_->state;
  if (gravity != state.scene.gravity)
  {
    state.scene.gravity = gravity;
    std::vector<int> all(state.bodies.size());
    std::iota(all.begin(), all.end(), 0);
    wake_islands_of(state, all);
  }
}

COOKBOOK_WORLD_INLINE void GameWorld::ignore(BodyId a, BodyId b)
{
  const std::pair<int, int> pair = woken_pair(a, b);
  std::vector<std::pair<int, int>>& ignored = inside_->state.scene.ignored;
  if (!ignores(scene(), pair))
  {
    ignored.insert(std::upper_bound(ignored.begin(), ignored.end(), pair), pair);
  }
}

COOKBOOK_WORLD_INLINE void GameWorld::stop_ignoring(BodyId a, BodyId b)
{
  std::erase(inside_->state.scene.ignored, woken_pair(a, b));
}

COOKBOOK_WORLD_INLINE void GameWorld::step()
{
  cookbook::step(inside_->state, inside_->solver);
}

/// Wakes a body and all that hangs together with it.
COOKBOOK_WORLD_INLINE void GameWorld::wake_island_of(BodyId body)
{
  const int number = static_cast<int>(index(body));
  wake_islands_of(inside_->state, {&number, 1});
}

/// The places of two bodies, the smaller one first; they wake. InvalidScene if they are one.
COOKBOOK_WORLD_INLINE std::pair<int, int> GameWorld::woken_pair(BodyId a, BodyId b)
{
  const std::pair<int, int> pair =
      checked_pair({static_cast<int>(index(a)), static_cast<int>(index(b))}, bodies().size());
  wake_island_of(a);
  wake_island_of(b);
  return pair;
}
// [world_calls]

} // namespace cookbook
