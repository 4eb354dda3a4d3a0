#include "05_resolution/small_world/small_world.hpp"
#include "05_resolution/small_world/step_1.hpp"
#include "05_resolution/small_world/step_2.hpp"
#include "05_resolution/small_world/step_3.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::small_world;

// [step_1]
TEST_CASE("step 1 holds a tower of five for 20 s, and neither ten nor a pyramid", "[long]")
{
  REQUIRE(largest_sink(tower<step_1::World>(5), 20) < 0.04);
  REQUIRE_FALSE(stands(largest_sink(tower<step_1::World>(10), 20)));
  REQUIRE_FALSE(stands(largest_sink(pyramid<step_1::World>(10), 20)));
}
// [step_1]

// [step_2]
TEST_CASE("step 2 holds a pyramid of 55 for 20 s, and no tower of ten for 40 s", "[long]")
{
  REQUIRE(largest_move(pyramid<step_2::World>(10), 20) < 0.04);
  REQUIRE_FALSE(stands(largest_sink(tower<step_2::World>(10), 40)));
}
// [step_2]

// [step_3]
TEST_CASE(
    "step 3 holds towers of ten for 40 s and of fourteen for 20 s, but not of sixteen", "[long]")
{
  REQUIRE(largest_sink(tower<step_3::World>(10), 40) < 0.04);
  REQUIRE(stands(largest_sink(tower<step_3::World>(14), 20)));
  REQUIRE_FALSE(stands(largest_sink(tower<step_3::World>(16), 20)));
}
// [step_3]

// [soft]
TEST_CASE("a cube under step 3 sinks by g / ω², .276 mm, as on springs of 30 Hz", "[R13]")
{
  const double angular_frequency = 2 * std::numbers::pi * 30;
  const double right = 9.81 / (angular_frequency * angular_frequency);
  REQUIRE(largest_sink(tower<step_3::World>(1), 5) == Approx(right).epsilon(1e-6));
}

TEST_CASE("a cube 30 cm in the ground hops over it by 21 cm under step 2, not under step 3")
{
  const auto highest = [](auto world)
  {
    add(world, cube({0, 0.2, 0}));
    double top = 0;
    for (int i = 0; i < 120; ++i)
    {
      step(world, frame);
      top = std::max(top, world.bodies[1].motion.center.y() - 0.5);
    }
    return top;
  };
  REQUIRE(highest(ground<step_2::World>()) > 0.2);
  REQUIRE(highest(ground<step_3::World>()) == 0);
}
// [soft]

namespace
{

/// Whether two worlds have the same bodies, to the last bit.
template <class One, class Other>
bool same_bodies(const One& one, const Other& other)
{
  for (std::size_t i = 0; i < one.bodies.size(); ++i)
  {
    const Motion<double>&a = one.bodies[i].motion, &b = other.bodies[i].motion;
    if (a.center != b.center || a.velocity != b.velocity ||
        a.angular_velocity != b.angular_velocity)
    {
      return false;
    }
  }
  return one.bodies.size() == other.bodies.size();
}

} // namespace

// [step_4]
TEST_CASE(
    "step 4 finds the contacts of step 3 among a tenth of its pairs, and moves alike", "[long]")
{
  auto every_pair = floor_of_cubes<step_3::World>(20);
  auto swept = floor_of_cubes<step_4::World>(20);
  const std::size_t count = swept.bodies.size();
  REQUIRE(pairs_compared(swept.bodies) * 10 < count * (count - 1) / 2);
  run(every_pair, 0.5);
  run(swept, 0.5);
  REQUIRE(swept.contacts.size() == 1600);
  REQUIRE(every_pair.contacts.size() == 1600);
  REQUIRE(same_bodies(every_pair, swept));
}
// [step_4]

// [step_5]
TEST_CASE("step 4 drops a sphere that step 5 bounces to e² times its height within 1 %; R19")
{
  REQUIRE(height_of_bounce(dropped_sphere<step_4::World>(1, 0.5), 1.2) < 0.01);
  for (const double e : {0.25, 0.5, 0.8, 1.0})
  {
    for (const double height : {0.5, 1.0, 5.0})
    {
      const double time = std::sqrt(2 * height / 9.81) * (1 + 2 * e);
      const double right = e * e * height;
      REQUIRE(
          height_of_bounce(dropped_sphere<step_5::World>(height, e), time) ==
          Approx(right).epsilon(0.01));
      REQUIRE(
          height_of_bounce(dropped_sphere<step_7::World>(height, e), time) ==
          Approx(right).epsilon(0.01));
    }
  }
}
// [step_5]

// [step_6]
TEST_CASE(
    "step 6 puts 400 cubes to sleep that step 5 goes on to solve, and a ball wakes four", "[long]")
{
  auto awake = floor_of_cubes<step_5::World>(20);
  auto world = floor_of_cubes<step_6::World>(20);
  run(awake, 2);
  run(world, 2);
  REQUIRE(awake.contacts.size() == 1600);
  REQUIRE(world.contacts.empty());
  RigidBody ball = sphere({0, 3, 0}, 0.25, 1);
  ball.motion.velocity = {0, -10, 0};
  add(world, ball);
  run(world, 0.2);
  int woken = 0;
  for (std::size_t i = 1; i <= 400; ++i)
  {
    woken += step_6::is_asleep(world, i) ? 0 : 1;
  }
  REQUIRE(woken == 4); // it falls where four cubes meet
}
// [step_6]

// [step_7]
TEST_CASE("step 7 returns spheres from a wall of 2 cm at 10 to 1,000 m/s; step 6 does not")
{
  for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    REQUIRE(comes_back(shot_at_wall<step_7::World>(speed)));
  }
  REQUIRE_FALSE(comes_back(shot_at_wall<step_6::World>(30)));
  REQUIRE_FALSE(comes_back(shot_at_wall<step_6::World>(1000)));
}
// [step_7]

// [friction]
TEST_CASE("the small world slides as far as Coulomb's friction lets it, within 1 %; R6")
{
  for (const double friction : {0.1, 0.3, 0.5})
  {
    auto world = ground<small_world::World>();
    world.bodies[0].friction = friction;
    RigidBody block = cube({-50, 0.5, 0});
    block.friction = friction;
    block.motion.velocity = {10, 0, 0};
    const std::size_t i = add(world, block);
    run(world, 12);
    const double right = 100 / (2 * friction * 9.81); // v² / (2 μ g)
    REQUIRE(world.bodies[i].motion.center.x() + 50 == Approx(right).epsilon(0.01));
  }
}
// [friction]

TEST_CASE("a block stays on a slope below the angle of friction, and slides above it")
{
  for (const double degrees : {10.0, 20.0, 35.0})
  {
    const double angle = degrees * std::numbers::pi / 180;
    small_world::World world;
    RigidBody slope = box({0, 0, 0}, {100, 0.5, 100}, 0);
    slope.friction = 0.3;
    set_orientation(slope, Quaternion<double>(Eigen::AngleAxisd(-angle, Vector3<double>::UnitZ())));
    add(world, slope);
    const Vector3<double> up = slope.orientation * Vector3<double>::UnitY();
    const Vector3<double> down = slope.orientation * Vector3<double>::UnitX();
    RigidBody block = cube(up);
    block.friction = 0.3;
    set_orientation(block, slope.orientation);
    const std::size_t i = add(world, block);
    run(world, 3);
    const double acceleration = std::max(0.0, 9.81 * (std::sin(angle) - 0.3 * std::cos(angle)));
    const double slid = (world.bodies[i].motion.center - up).dot(down);
    REQUIRE(slid == Approx(acceleration * 4.5).epsilon(0.01).margin(0.001));
  }
}

// [deterministic]
TEST_CASE("the same world twice moves alike to the last bit, and so does a copy")
{
  auto one = pyramid<small_world::World>(5);
  auto other = pyramid<small_world::World>(5);
  one.bodies.back().motion.velocity.x() = other.bodies.back().motion.velocity.x() = 3;
  run(one, 1);
  run(other, 1);
  REQUIRE(same_bodies(one, other));
  small_world::World copy = one;
  run(one, 1);
  run(copy, 1);
  REQUIRE(same_bodies(one, copy));
}
// [deterministic]

TEST_CASE("the small world refuses what it is not made for, by name and value")
{
  small_world::World world;
  const double none = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_THROWS_WITH(
      add(world, box({0, 0, 0}, {1, none, 1}, 1)),
      "half_extents is nan; it must be from 0.001000 to 1000.000000");
  RigidBody fast = cube({0, 0, 0});
  fast.motion.velocity = {2e4, 0, 0};
  REQUIRE_THROWS_WITH(
      add(world, fast),
      "velocity.norm() is 20000.000000; it must be from 0.000000 to 10000.000000");
  REQUIRE_THROWS(add(world, cube({none, 0, 0})));
  REQUIRE_THROWS(add(world, box({0, 0, 0}, {1, 1, 1}, -1)));
  REQUIRE_THROWS(step(world, 0));
  REQUIRE_THROWS(step(world, none));
  REQUIRE(world.bodies.empty());
}
