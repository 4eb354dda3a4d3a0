/// \file
/// Bodies that a game puts elsewhere: what falls there, what wakes, and that nothing in between is
/// hit.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_queries.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <string>

using namespace cookbook;
using Catch::Matchers::ContainsSubstring;

namespace
{

const Quaternion<double> straight = Quaternion<double>::Identity();

void on(GameWorld& world, double time)
{
  for (const double end = world.time() + time; world.time() < end - 1e-9;)
  {
    world.step();
  }
}

} // namespace

// [teleport]
TEST_CASE("a cube that is put on a tower stands there as if it had from the start")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    CAPTURE(solver);
    Scene scene = named_scene("tower_3");
    scene.bodies.push_back(cube_body("late", {7, 0.5, 0}));
    GameWorld put(scene, solver_named(solver));
    scene.bodies[4].position = {0, 3.5, 0};
    GameWorld always(scene, solver_named(solver));
    put.set_pose(4, {0, 3.5, 0}, straight);
    on(put, 2);
    on(always, 2);
    for (std::size_t i = 0; i < 5; ++i)
    {
      CHECK(put.body(i).motion.center == always.body(i).motion.center);
    }
  }
}

TEST_CASE("a ball that is put behind a wall keeps its velocity, and hits nothing in between")
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {box_body("wall", {0.1, 5, 5}, {0, 0, 0}, 0), ball_body("ball", 0.1, {-2, 0, 0})};
  scene.bodies[1].velocity = {6, 0, 0};
  GameWorld world(scene, solver_named("direct"));
  world.step();
  world.set_pose(1, {2, 0, 0}, {0, 0, 1.5, 0}); // made 1
  CHECK(world.body(1).orientation.coeffs() == Eigen::Vector4d(0, 1, 0, 0));
  CHECK(world.scene().bodies[1].orientation.coeffs() == Eigen::Vector4d(0, 1, 0, 0));
  CHECK(world.scene().bodies[1].position == Vector3<double>(2, 0, 0));
  const Ray<double> along{{1, 0, 0}, {1, 0, 0}};
  CHECK(WorldQueries(world).cast(along)->hit.t == Catch::Approx(0.9));
  world.step();
  CHECK(world.impacts().empty());
  CHECK(world.body(1).motion.center.x() == Catch::Approx(2.1));
  CHECK(world.body(1).motion.velocity == Vector3<double>(6, 0, 0));
}

TEST_CASE("what leaned on it falls, what sleeps where it is put wakes, and others sleep on")
{
  for (const bool table : {false, true})
  {
    CAPTURE(table);
    Scene scene{.bodies = {ground(), cube_body("below", {0, 0.5, 0})}};
    scene.bodies[1].mass = table ? 0 : 1;
    scene.bodies.push_back(cube_body("upper", {0, 1.5, 0}));
    scene.bodies.push_back(cube_body("there", {10, 0.5, 0}));
    scene.bodies.push_back(cube_body("far", {20, 0.5, 0}));
    GameWorld world(scene, solver_named("direct"), true);
    on(world, 3);
    REQUIRE(world.is_asleep(2));
    world.set_pose(1, {10.9, 0.5, 0}, straight); // .1 m deep
    CHECK_FALSE(world.is_asleep(1));
    CHECK_FALSE(world.is_asleep(2));
    CHECK_FALSE(world.is_asleep(3));
    CHECK(world.is_asleep(4));
    world.set_pose(4, {20, 2.5, 0}, straight); // alone
    on(world, 3);
    CHECK(world.body(4).motion.center.y() == Catch::Approx(0.5).margin(1e-3));
    CHECK(world.body(2).motion.center.y() == Catch::Approx(0.5).margin(1e-3));
    const double separation = world.body(1).motion.center.x() - world.body(3).motion.center.x();
    CHECK(separation == Catch::Approx(1).margin(2e-3));
  }
}

TEST_CASE("a scene that is moved by a kilometre goes on as it would have, a kilometre away")
{
  const Vector3<double> shift(1000, 0, -500);
  GameWorld moved(named_scene("domino_20"), solver_named("wide_steps"));
  GameWorld left = moved;
  on(moved, 1);
  on(left, 1);
  for (std::size_t i = 1; i < moved.bodies().size(); ++i)
  {
    moved.set_pose(i, moved.body(i).motion.center + shift, moved.body(i).orientation);
  }
  on(moved, 1);
  on(left, 1);
  for (std::size_t i = 1; i < moved.bodies().size(); ++i)
  {
    const Vector3<double> separation = moved.body(i).motion.center - left.body(i).motion.center;
    CHECK((separation - shift).norm() <= 1e-6);
  }
}

TEST_CASE("what is put to no place, or turned by nothing, is refused by name, and stays")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"));
  world.add(cube_body("gone", {5, 0.5, 0}));
  world.remove(3);
  on(world, 0.5);
  const GameWorld before = world;
  const double huge = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(
      world.set_pose(1, {0, huge, 0}, straight), ContainsSubstring("position.y must be finite"));
  CHECK_THROWS_WITH(
      world.set_pose(1, {0, 1, 0}, {0, 0, 0, 0}), ContainsSubstring("orientation must be"));
  CHECK_THROWS_WITH(
      world.set_pose(1, {0, 1, 0}, {std::nan(""), 0, 0, 0}),
      ContainsSubstring("orientation must be"));
  CHECK_THROWS_WITH(
      world.set_pose(0, {0, 1, 0}, straight), ContainsSubstring("shape must be a box or a ball"));
  CHECK_THROWS_WITH(world.set_pose(3, {0, 1, 0}, straight), ContainsSubstring("any more"));
  CHECK_THROWS_WITH(world.set_pose(9, {0, 1, 0}, straight), ContainsSubstring("no body 9"));
  for (std::size_t i = 0; i < world.bodies().size(); ++i)
  {
    CHECK(world.bodies()[i].motion.center == before.bodies()[i].motion.center);
  }
}
// [teleport]

TEST_CASE("put where it is in every step, a cube in a tower changes nothing")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    GameWorld put(named_scene("tower_10"), solver_named(solver));
    GameWorld left = put;
    for (int i = 0; i < 240; ++i)
    {
      const RigidBody cube = put.body(5);
      put.set_pose(5, cube.motion.center, cube.orientation);
      put.step();
      left.step();
    }
    for (std::size_t i = 0; i < put.bodies().size(); ++i)
    {
      CAPTURE(solver, i);
      CHECK((put.body(i).motion.center - left.body(i).motion.center).norm() <= 1e-9);
    }
  }
}

TEST_CASE("put into the ground, or tilted in a stack, it comes out, and slowly")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double deep : {0.01, 0.3, 0.9})
    {
      CAPTURE(solver, deep);
      GameWorld world(named_scene("tower_3"), solver_named(solver));
      on(world, 1);
      world.set_pose(3, {5, 0.5 - deep, 0}, straight);
      world.set_pose(2, {0, 1.5, 0}, turn_about_z(0.96, 0.28));
      double fastest = 0;
      for (int i = 0; i < 300; ++i)
      {
        world.step();
        fastest = std::max(fastest, world.body(3).motion.velocity.norm());
      }
      CHECK(fastest <= 5);
      CHECK(world.body(3).motion.center.y() == Catch::Approx(0.5).margin(5e-3));
      CHECK(world.body(2).motion.center.y() == Catch::Approx(1.5).margin(5e-3));
    }
  }
}
