/// \file
/// What holds for the small world's bodies under corrected positions, and what falls.

#include "05_resolution/plain_positions/plain_positions.hpp"
#include "05_resolution/plain_positions/trial/plain_scenes.hpp"
#include "tests/catch.hpp"

#include <numbers>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::small_world;
using plain_positions::World;

// [loads]
TEST_CASE("two cubes under corrected positions press by their weights within 1 %", "[R9]")
{
  World world = tower<World>(2);
  run(world, 5);
  for (std::size_t below = 0; below < 2; ++below)
  {
    double load = 0; // [N], of the last step
    for (const plain_positions::Contact& contact : world.contacts)
    {
      load += contact.a == below ? contact.total_impulse / frame : 0;
    }
    REQUIRE(load == Approx(9.81 * (2.0 - static_cast<double>(below))).epsilon(0.01));
  }
}
// [loads]

// [stands]
TEST_CASE(
    "corrected positions hold towers of up to seven, which sink by N slops and the sink of R16 "
    "within 6 %; ten sway, and fall",
    "[R16][long]")
{
  const double substep = frame / 20;
  for (int cubes = 1; cubes <= 7; ++cubes)
  {
    const double unsolved = 0.5 * cubes * (cubes - 1) * 9.81 * substep * substep;
    const double sink = largest_sink(tower<World>(cubes), 20);
    REQUIRE(sink == Approx(cubes * plain_positions::slop + unsolved).epsilon(0.06));
  }
  REQUIRE(largest_move(tower<World>(10), 5) < 0.02);
  REQUIRE_FALSE(stands(largest_sink(tower<World>(10), 20)));
}

TEST_CASE("corrected positions hold 100 kg on 1 kg, and not 1,000 kg", "[long]")
{
  REQUIRE(largest_sink(heavy_on_light<World>(100), 10) < 0.003);
  REQUIRE_FALSE(stands(largest_sink(heavy_on_light<World>(1000), 10)));
}
// [stands]

// [friction]
TEST_CASE("under corrected positions a cube slides as Coulomb says within 1 %, or stays", "[R28]")
{
  for (const double degrees : {20.0, 25.0, 35.0})
  {
    REQUIRE(
        distance_gone(slope<World>(degrees, 0.3), 3) ==
        Approx(right_slide(degrees, 0.3, 3)).epsilon(0.01));
  }
  REQUIRE(distance_gone(slope<World>(10, 0.3), 3) < 0.0005);
  REQUIRE(distance_gone(slope<World>(16, 0.3), 3) < 0.0005);
}

TEST_CASE("under corrected positions a cube stops after v² / (2 μ g) within 1 %", "[R29][long]")
{
  for (const double friction : {0.1, 0.3, 0.5})
  {
    World world = slope<World>(0, friction);
    world.bodies.back().motion.velocity = {6, 0, 8};
    REQUIRE(distance_gone(world, 12) == Approx(100 / (2 * friction * 9.81)).epsilon(0.01));
  }
}
// [friction]

// [shift]
TEST_CASE("a shift moves and turns a body as an impulse that acts for a second", "[R15]")
{
  World world;
  world.gravity.setZero();
  RigidBody body = box({0, 0, 0}, {0.5, 0.4, 0.3}, 2);
  add(world, body);
  const plain_positions::Bodies before = world.bodies;
  plain_positions::shift(world.bodies[0], {0, 0.4, 0}, {0.05, 0, 0}, 1);
  plain_positions::compute_velocities(world, before, 1);
  const Motion<double>& moved = world.bodies[0].motion;
  REQUIRE(moved.velocity.x() == Approx(0.025)); // p / m
  const double inertia = 2.0 / 3 * (0.25 + 0.16);
  REQUIRE(moved.angular_velocity.z() == Approx(-0.02 / inertia).epsilon(0.001));
}
// [shift]

TEST_CASE("a cube that starts 40 cm in the ground comes out, and hops by less than 2 cm")
{
  World world = ground<World>();
  add(world, cube({0, 0.1, 0}));
  double highest = 0;
  for (int i = 0; i < 120; ++i)
  {
    step(world, frame);
    highest = std::max(highest, world.bodies[1].motion.center.y());
  }
  REQUIRE(highest < 0.52);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5).margin(0.001));
}

TEST_CASE("piles under corrected positions stay over the ground and fall alike twice", "[long]")
{
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U})
  {
    World world = pile<World>(seed), again = pile<World>(seed);
    for (int i = 0; i < 240; ++i)
    {
      step(world, frame);
      step(again, frame);
      REQUIRE(is_sane(world));
    }
    for (std::size_t i = 0; i < world.bodies.size(); ++i)
    {
      REQUIRE(world.bodies[i].motion.center == again.bodies[i].motion.center);
    }
  }
}
