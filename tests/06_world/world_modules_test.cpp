/// \file
/// Each module of a world left out: it runs, and a scene that does not need it moves to the bit as
/// with it; one that needs it does not.

#include "05_resolution/small_world/step_3.hpp"
#include "06_world/game_world/game_modules.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

// [all_but]
/// All modules but those of a type.
template <class Module>
WorldModules all_but(bool may_sleep = false)
{
  WorldModules modules = game_modules(may_sleep);
  std::erase_if(
      modules.list,
      [](const Cloned<WorldModule>& one) { return dynamic_cast<const Module*>(&*one) != nullptr; });
  return modules;
}
// [all_but]

/// All modules, and every pair of bounds compared.
WorldModules by_every_pair()
{
  WorldModules modules = game_modules(false);
  modules.pair_finder = EveryPair();
  return modules;
}

/// Whether two worlds are where they are, and move as they do, to the bit.
bool are_equal(const GameWorld& one, const GameWorld& other)
{
  const auto same = [](const RigidBody& a, const RigidBody& b)
  {
    return a.motion.center == b.motion.center && a.motion.velocity == b.motion.velocity &&
           a.motion.angular_velocity == b.motion.angular_velocity &&
           a.orientation.coeffs() == b.orientation.coeffs();
  };
  return std::equal(
      one.bodies().begin(), one.bodies().end(), other.bodies().begin(), other.bodies().end(), same);
}

void run(GameWorld& world, int steps)
{
  for (int step = 0; step < steps; ++step)
  {
    world.step();
  }
}

const std::vector<std::string> recommended{"direct", "soft_steps", "wide_steps"};

/// Whether scenes come out alike after 1.5 s, with all modules and with these.
void check_alike(
    const std::vector<std::string>& scenes, const WorldModules& modules, bool may_sleep = false)
{
  for (const std::string& name : scenes)
  {
    for (const std::string& solver : recommended)
    {
      CAPTURE(name, solver);
      GameWorld all(named_scene(name), solver_named(solver), may_sleep);
      GameWorld fewer(named_scene(name), solver_named(solver), modules);
      run(all, 90);
      run(fewer, 90);
      CHECK(are_equal(all, fewer));
    }
  }
}

/// The last body of a scene after so many steps.
RigidBody
last_body(const Scene& scene, const std::string& solver, const WorldModules& modules, int steps)
{
  GameWorld world(scene, solver_named(solver), modules);
  run(world, steps);
  return world.bodies().back();
}

/// So many cubes on each other.
Scene cubes_on_each_other(int count)
{
  Scene scene{.bodies = {ground()}};
  for (int i = 0; i < count; ++i)
  {
    scene.bodies.push_back(cube_body(numbered("cube", i), {0, 0.5 + i, 0}));
  }
  return scene;
}

/// What a scene that is called by a module does in its steps, for a game's own module.
struct Counting : WorldModule
{
  void solved(WorldState& world) override { world.bodies[1].motion.velocity.x() = ++steps; }
  int steps = 0;
};

} // namespace

// [modules_left_out]
TEST_CASE("without hit events nothing is told; heaps, and a wall that is hit, stay to the bit")
{
  check_alike({"pile_20", "wall_hit_3", "bounce"}, all_but<HitEvents>());
  GameWorld all(named_scene("pile_20"), solver_named("soft_steps"));
  GameWorld none(named_scene("pile_20"), solver_named("soft_steps"), all_but<HitEvents>());
  std::size_t told = 0;
  for (int step = 0; step < 60; ++step)
  {
    all.step();
    none.step();
    told += all.impacts().size();
    CHECK(none.impacts().empty());
  }
  CHECK(told > 10);
}

TEST_CASE("by every pair, without a tree, heaps, and a wall that is hit, stay to the bit")
{
  check_alike({"pile_20", "pit_20", "wall_hit_3"}, by_every_pair());
}

TEST_CASE("without flush surfaces a heap on one slab stays to the bit; over tiles of 30 cm soft "
          "steps slow a sphere of 20 cm from .5 to .48 m/s")
{
  check_alike({"pile_20", "wall_hit_3"}, all_but<FlushSurfaces>());
  Scene scene;
  for (int i = -1; i < 9; ++i)
  {
    scene.bodies.push_back(box_body(numbered("tile", i), {0.15, 0.5, 2}, {0.3 * i, -0.5, 0}, 0));
  }
  scene.bodies.push_back(ball_body("sphere", 0.2, {0, 0.2, 0}));
  scene.bodies.back().velocity = {0.5, 0, 0};
  scene.bodies.back().angular_velocity = {0, 0, -2.5};
  const auto speed = [&](const WorldModules& modules)
  { return last_body(scene, "soft_steps", modules, 240).motion.velocity.norm(); };
  CHECK(speed(all_but<FlushSurfaces>()) < 0.485);
  CHECK(speed(game_modules(false)) == Catch::Approx(0.5).epsilon(1e-9));
}

TEST_CASE("without islands a tower, which is one, stays to the bit; a cube that slides elsewhere "
          "keeps it awake")
{
  check_alike({"tower_5", "tiles"}, all_but<FindIslands>());
  Scene scene = cubes_on_each_other(3);
  scene.bodies.push_back(cube_body("slider", {0, 0.5, 5}));
  scene.bodies.back().friction = 0;
  scene.bodies.back().velocity = {1, 0, 0};
  for (const bool with : {false, true})
  {
    GameWorld world(
        scene, solver_named("soft_steps"), with ? game_modules(true) : all_but<FindIslands>(true));
    run(world, 120);
    CHECK(world.is_asleep(1) == with);
    CHECK_FALSE(world.is_asleep(4));
  }
}

TEST_CASE("without sleeping what flies or slides stays to the bit; a tower does not fall asleep")
{
  check_alike({"swarm_20", "tiles", "rolling"}, all_but<Sleeping>(true), true);
  for (const bool with : {false, true})
  {
    GameWorld world(
        cubes_on_each_other(3), solver_named("soft_steps"),
        with ? game_modules(true) : all_but<Sleeping>(true));
    run(world, 120);
    CHECK(world.is_asleep(1) == with);
  }
}

TEST_CASE(
    "without restitution heaps that do not bounce stay to the bit; an elastic cube that falls "
    "1 m stays down, which rises to 1 m")
{
  check_alike({"pile_20", "pit_20", "tower_5"}, all_but<Restitution>());
  Scene scene{.bodies = {ground(), cube_body("cube", {0, 1.5, 0})}};
  scene.bodies.back().restitution = 1;
  for (const std::string& solver : recommended)
  {
    CAPTURE(solver);
    const auto height = [&](const WorldModules& modules) // after 2 √(2 / g) = .903 s
    { return last_body(scene, solver, modules, 54).motion.center.y(); };
    CHECK(height(all_but<Restitution>()) == Catch::Approx(0.5).margin(0.001));
    CHECK(height(game_modules(false)) == Catch::Approx(1.5).margin(0.001));
  }
}

TEST_CASE(
    "without continuous collision towers, and what flies, stay to the bit; a sphere at 100 m/s "
    "passes a wall of 2 cm, a cube of 20 cm at 30 m/s the ground")
{
  check_alike({"tower_5", "spinning_top", "swarm_20", "floor_9"}, all_but<Continuous>());
  Scene falling{.bodies = {ground(), box_body("cube", {0.1, 0.1, 0.1}, {0, 1.25, 0})}};
  falling.bodies.back().velocity = {0, -30, 0};
  Scene shot = named_scene("thin_wall_100");
  shot.bodies.pop_back(); // the sphere that passes by
  for (const std::string& solver : recommended)
  {
    CAPTURE(solver);
    const auto last = [&](const Scene& scene, bool with, int steps)
    {
      const WorldModules modules = with ? game_modules(false) : all_but<Continuous>();
      return last_body(scene, solver, modules, steps).motion.center;
    };
    CHECK(last(shot, false, 3).x() > 2);
    CHECK(last(shot, true, 3).x() < -2);
    CHECK(last(falling, false, 3).y() < -0.2);
    CHECK(last(falling, true, 3).y() > 0.09);
  }
}

TEST_CASE(
    "with no module at all, by every pair, a tower of ten stands as with all, to the bit, and "
    "a copy goes on to the bit")
{
  WorldModules none;
  none.pair_finder = EveryPair();
  check_alike({"tower_10", "swarm_20"}, none);
  GameWorld world(named_scene("tower_10"), solver_named("soft_steps"), none);
  run(world, 120);
  GameWorld copy = world;
  run(world, 60);
  run(copy, 60);
  CHECK(are_equal(world, copy));
}

TEST_CASE(
    "by every pair, 300 cubes in one place are refused as by the tree, and stay where they are")
{
  Scene scene;
  for (int i = 0; i < 300; ++i)
  {
    scene.bodies.push_back(cube_body(numbered("cube", i), {0, 0.5, 0}));
  }
  GameWorld world(scene, solver_named("soft_steps"), by_every_pair());
  CHECK_THROWS_AS(world.step(), TooManyContacts);
  CHECK(world.bodies()[7].motion.center.y() == 0.5);
}

TEST_CASE(
    "a module of a game's own is called in each step, and a copy of the world counts on alone")
{
  WorldModules modules;
  modules.list = {Counting()};
  GameWorld world(cubes_on_each_other(1), solver_named("soft_steps"), modules);
  run(world, 3);
  GameWorld copy = world;
  run(copy, 4);
  CHECK(world.bodies()[1].motion.velocity.x() == 3);
  CHECK(copy.bodies()[1].motion.velocity.x() == 7);
}
// [modules_left_out]

// [small_and_bare]
TEST_CASE(
    "a cube sinks by g / ω², .276 mm, under step 3 of the small world and with no module; ten "
    "stand in both")
{
  namespace small = small_world;
  for (const int count : {1, 10})
  {
    small::step_3::World step_3;
    add(step_3, small::box({0, -1, 0}, {10, 1, 10}, 0));
    for (int i = 0; i < count; ++i)
    {
      add(step_3, small::box({0, i + 0.5, 0}, {0.5, 0.5, 0.5}, 1));
    }
    WorldModules none;
    none.pair_finder = EveryPair();
    GameWorld bare(cubes_on_each_other(count), solver_named("soft_steps"), none);
    for (int i = 0; i < 1200; ++i)
    {
      step(step_3, 1.0 / 60);
      bare.step();
    }
    const double top = count - 0.5;
    const double sinks_small = top - step_3.bodies.back().motion.center.y();
    const double sinks_bare = top - bare.bodies().back().motion.center.y();
    if (count == 1)
    {
      const double omega = 2 * 3.14159265358979 * 0.125 * 240; // springs of 30 Hz
      CHECK(sinks_small == Catch::Approx(9.81 / (omega * omega)).epsilon(1e-5));
      CHECK(sinks_bare == Catch::Approx(9.81 / (omega * omega)).epsilon(1e-5));
    }
    CHECK(std::max(sinks_small, sinks_bare) < 0.04);
  }
}
// [small_and_bare]
