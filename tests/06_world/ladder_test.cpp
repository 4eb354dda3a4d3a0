/// \file
/// What holds for the ladder: each rung holds what the one below fails, both worlds agree where
/// they share, and lines are counted.

#include "05_resolution/small_world/small_world.hpp"
#include "05_resolution/small_world/trial/step_rungs.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/ladder/trial/ladder.hpp"
#include "06_world/ladder/trial/ladder_rungs.hpp"
#include "06_world/ladder/trial/ladder_scenes.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

using namespace cookbook;

// [rungs]
TEST_CASE("each step and each branch holds the scene that the rung below fails", "[long]")
{
  std::vector<Rung> rungs = small_world::step_rungs();
  REQUIRE(rungs.size() == 7);
  const std::vector<Rung> branches = branch_rungs();
  rungs.insert(rungs.end(), branches.begin(), branches.end());
  for (const Rung& rung : rungs)
  {
    CAPTURE(rung.adds, rung.scene, rung.below.what, rung.here.what);
    CHECK_FALSE(rung.below.holds);
    CHECK(rung.here.holds);
  }
}
// [rungs]

// [direct]
TEST_CASE("1,000 kg on 1 kg stand under the direct solver alone, and press as statics says; R9")
{
  const Scene scene = scenes::heavy_on_light(1000);
  CHECK_FALSE(
      small_world::stands(small_world::largest_sink(small_of<small_world::World>(scene), 20)));
  CHECK_FALSE(small_world::stands(run_world(scene, {.solver = "soft_steps", .duration = 20}).sink));
  CHECK(run_world(scene, {.solver = "direct", .duration = 20}).sink < 1e-6);
  const std::vector<double> loads = warm_start_impulse(scene, "direct", 1200);
  CHECK(60 * loads[1] == Catch::Approx(1001 * 9.81).epsilon(1e-12));
  CHECK(60 * loads[2] == Catch::Approx(1000 * 9.81).epsilon(1e-12));
}
// [direct]

// [both]
TEST_CASE(
    "eight wide steps hold a tower of 30 and 300 kg on 1 kg; 1,000 kg take the direct solver",
    "[long]")
{
  const auto sink = [](const Scene& scene, int substeps)
  { return run_world(scene, {.solver = "wide_steps", .substeps = substeps, .duration = 20}).sink; };
  CHECK(sink(scenes::tower(30), 8) < 0.06);
  CHECK(sink(scenes::heavy_on_light(300), 8) < 0.05);
  CHECK_FALSE(small_world::stands(sink(scenes::heavy_on_light(300), 4)));
  CHECK_FALSE(small_world::stands(sink(scenes::heavy_on_light(1000), 8)));
}
// [both]

// [agreement]
TEST_CASE("step 7 and GameWorld agree on ten scenes: 1 mm at rest, half a percent in motion")
{
  const std::vector<Agreement> all = agreements();
  REQUIRE(all.size() == 10);
  for (const Agreement& one : all)
  {
    CAPTURE(one.scene, one.moved, one.separation);
    CHECK(one.separation <= allowed(one));
    CHECK(one.rests == (one.moved < 0.01));
  }
}

TEST_CASE("step 7 and GameWorld call the same functions of a contact, a bounce and a body")
{
  for (const SharedFunction& one : shared_functions())
  {
    CAPTURE(one.name);
    CHECK(calls(one.of_step_7, one.name));
    CHECK(calls(one.of_game_world, one.name));
  }
  CHECK_FALSE(calls("05_resolution/small_world/step_1.hpp", "solve_contact"));
}

TEST_CASE(
    "a sphere in flight is g t h/8 too low in four substeps of step 7, and exact in GameWorld")
{
  small_world::World small = small_of<small_world::World>(thrown_sphere());
  GameWorld game(thrown_sphere(), solver_named("soft_steps"));
  for (int i = 0; i < 120; ++i)
  {
    small_world::step(small, small_world::frame);
    game.step();
  }
  const double right = 10 * 2 - 9.81 * 2;
  CHECK(game.body(0).motion.center.y() == Catch::Approx(right).epsilon(1e-12));
  const double low = 9.81 * 2 * small_world::frame / 8;
  CHECK(small.bodies[0].motion.center.y() == Catch::Approx(right - low).epsilon(1e-12));
}
// [agreement]

TEST_CASE("a scene becomes a small world: shapes, masses, motions and surfaces stay")
{
  Scene scene = scenes::standing();
  SceneBody cube = cube_body("cube", {1, 2, 3}, 4);
  cube.orientation = whole_turn(1, 2, 3, 4);
  cube.velocity = {1, 2, 3};
  cube.angular_velocity = {4, 5, 6};
  cube.friction = 0.25;
  cube.restitution = 0.75;
  scene.bodies.push_back(cube);
  scene.bodies.push_back(ball_body("sphere", 0.25, {7, 8, 9}, 2));
  const small_world::World world = small_of<small_world::World>(scene);
  REQUIRE(world.bodies.size() == 3);
  const small_world::RigidBody &ground = world.bodies[0], &box = world.bodies[1];
  CHECK(ground.inverse_mass == 0);
  CHECK(ground.motion.center.y() + ground.half_extents.y() == 0);
  CHECK(box.motion.center == cube.position);
  CHECK(box.motion.velocity == cube.velocity);
  CHECK(box.motion.angular_velocity == cube.angular_velocity);
  CHECK(box.orientation.angularDistance(cube.orientation) < 1e-15);
  CHECK(box.inverse_mass == 0.25);
  CHECK((box.friction == 0.25 && box.restitution == 0.75 && !box.is_sphere));
  CHECK((world.bodies[2].is_sphere && world.bodies[2].half_extents.x() == 0.25));
  const Scene slope = scenes::incline(0.28, 0.5);
  const small_world::RigidBody tilted = small_body(slope.bodies[0]);
  const Vector3<double> top = tilted.motion.center + tilted.orientation * Vector3<double>::UnitY();
  CHECK(top.norm() < 1e-15);
}

// [lines]
TEST_CASE(
    "what the ladder says of lines is within a twentieth of what ./cookbook take prints", "[long]")
{
  for (const LinesTaken& one : lines_taken())
  {
    const double counted = static_cast<double>(lines_to_take(one.headers));
    CAPTURE(one.rung, counted);
    CHECK(one.lines % 100 == 0);
    CHECK(std::abs(one.lines - counted) <= counted / 20);
  }
}
// [lines]
