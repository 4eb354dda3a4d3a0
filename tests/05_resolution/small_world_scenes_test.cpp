#include "05_resolution/small_world/small_world.hpp"
#include "05_resolution/small_world/step_4.hpp"
#include "05_resolution/small_world/step_5.hpp"
#include "05_resolution/small_world/step_6.hpp"
#include "05_resolution/small_world/trial/small_scenes.hpp"
#include "05_resolution/tunnelling/swept_sphere.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using Catch::Approx;
using namespace cookbook;
using namespace cookbook::small_world;
using small_world::World;

namespace
{

/// A world without gravity, and nothing in it.
World space()
{
  World world;
  world.gravity.setZero();
  return world;
}

/// A sphere that moves.
RigidBody shot(const Vector3<double>& center, double radius, const Vector3<double>& velocity)
{
  RigidBody body = sphere(center, radius, 1);
  body.motion.velocity = velocity;
  return body;
}

/// A box turned by an angle [rad] about an axis.
RigidBody turned(RigidBody body, double angle, const Vector3<double>& axis)
{
  set_orientation(body, Quaternion<double>(Eigen::AngleAxisd(angle, axis.normalized())));
  return body;
}

/// The momentum [N s] of all bodies that can move.
Vector3<double> momentum_of(const World& world)
{
  Vector3<double> sum = Vector3<double>::Zero();
  for (const RigidBody& body : world.bodies)
  {
    if (body.inverse_mass > 0)
    {
      sum += body.motion.velocity / body.inverse_mass;
    }
  }
  return sum;
}

/// The kinetic energy of all bodies and their height in gravity [J].
double energy_of(const World& world)
{
  double sum = 0;
  for (const RigidBody& body : world.bodies)
  {
    if (body.inverse_mass > 0)
    {
      const auto& [center, velocity, angular_velocity] = body.motion;
      const Vector3<double> spin = body.orientation.conjugate() * angular_velocity;
      sum += (velocity.squaredNorm() / 2 - world.gravity.dot(center)) / body.inverse_mass +
             spin.dot(body.moments.cwiseProduct(spin)) / 2;
    }
  }
  return sum;
}

/// How many bodies are asleep.
std::size_t sleepers(const World& world)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    count += small_world::is_asleep(world, i) ? 1U : 0U;
  }
  return count;
}

} // namespace

// [spheres_at_spheres]
TEST_CASE("spheres that fly in line at 100 m/s, half a metre apart, do not meet")
{
  World world = space();
  for (int i = 0; i < 3; ++i)
  {
    add(world, shot({0.5 * i, 0, 0}, 0.05, {100, 0, 0}));
  }
  run(world, 0.5);
  for (int i = 0; i < 3; ++i)
  {
    const Motion<double>& motion = world.bodies[static_cast<std::size_t>(i)].motion;
    REQUIRE(motion.velocity.x() == 100);
    REQUIRE(motion.center.x() == Approx(50 + 0.5 * i).epsilon(1e-9));
  }
}

TEST_CASE("spheres that meet head-on at 5 to 300 m/s exchange their velocities with e = 1")
{
  for (const double speed : {5.0, 20.0, 100.0, 300.0})
  {
    World world = space();
    add(world, shot({-5, 0, 0}, 0.05, {speed, 0, 0}));
    add(world, shot({5.3, 0, 0}, 0.05, {-speed, 0, 0}));
    world.bodies[0].restitution = 1;
    run(world, 20 / speed);
    REQUIRE(world.bodies[0].motion.velocity.x() == Approx(-speed).epsilon(1e-9));
    REQUIRE(world.bodies[1].motion.velocity.x() == Approx(speed).epsilon(1e-9));
    const double middle = world.bodies[0].motion.center.x() + world.bodies[1].motion.center.x();
    REQUIRE(middle == Approx(0.3).epsilon(1e-9));
  }
}
// [spheres_at_spheres]

TEST_CASE(
    "thirty spheres that fly about a room at up to 87 m/s stay in it, and gain no energy", "[long]")
{
  for (const unsigned seed : {1U, 2U, 3U})
  {
    World world = space();
    for (const int axis : {0, 1, 2})
    {
      for (const double side : {-1.0, 1.0})
      {
        Vector3<double> center = Vector3<double>::Zero(), half_extents{3.2, 3.2, 3.2};
        center[axis] = 3.1 * side;
        half_extents[axis] = 0.1;
        add(world, box(center, half_extents, 0));
      }
    }
    Random random(seed);
    for (int i = 0; i < 30; ++i)
    {
      const Vector3<double> place = random.in_cube(2.5), velocity = random.in_cube(50);
      add(world, shot(place, 0.1, velocity));
      world.bodies.back().restitution = 1;
    }
    const double energy = energy_of(world);
    run(world, 10);
    REQUIRE(energy_of(world) < energy * (1 + 1e-9));
    for (const RigidBody& body : world.bodies)
    {
      REQUIRE((body.inverse_mass == 0 || body.motion.center.cwiseAbs().maxCoeff() < 3));
    }
  }
}

TEST_CASE("a shot at a sphere at rest gives it all of its velocity with e = 1, whatever the speed")
{
  for (const double speed : {5.0, 50.0, 300.0, 3000.0})
  {
    World world = space();
    add(world, shot({-5, 0, 0}, 0.05, {speed, 0, 0}));
    add(world, shot({0, 0, 0}, 0.05, {0, 0, 0}));
    world.bodies[0].restitution = 1;
    run(world, 10 / speed + 0.1);
    REQUIRE(world.bodies[1].motion.velocity.x() == Approx(speed).epsilon(1e-9));
    REQUIRE(std::abs(world.bodies[0].motion.velocity.x()) < 1e-9 * speed);
  }
}

TEST_CASE("a sphere in a wagon of 60 m/s bounces off its walls as if the wagon stood")
{
  for (const double speed : {0.0, 60.0})
  {
    World world = space();
    for (const double side : {-1.0, 1.0})
    {
      RigidBody wall = box({side, 0, 0}, {0.02, 1, 1}, 0);
      wall.motion.velocity.x() = speed;
      add(world, wall);
    }
    add(world, shot({0, 0, 0}, 0.05, {speed + 5, 0, 0}));
    world.bodies[2].restitution = 1;
    run(world, 0.3); // 0.93 m to the wall take 0.186 s
    REQUIRE(world.bodies[2].motion.velocity.x() - speed == Approx(-5).epsilon(1e-9));
  }
}

TEST_CASE("a sphere dropped in a train of 100 m/s comes back to e² of its height, on its place")
{
  World world;
  add(world, box({0, -0.5, 0}, {500, 0.5, 20}, 0));
  world.bodies[0].motion.velocity.x() = 100;
  add(world, shot({0, 1.1, 0}, 0.1, {100, 0, 0}));
  world.bodies[1].restitution = 0.5;
  REQUIRE(height_of_bounce(world, 1) == Approx(0.25).epsilon(0.01));
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.x() == Approx(100).epsilon(1e-9));
}

// [seams]
TEST_CASE("a sphere crosses the seams of flush boxes at 10 to 60 m/s and keeps its speed")
{
  for (const double speed : {10.0, 30.0, 60.0})
  {
    World world;
    for (int i = 0; i < 50; ++i)
    {
      add(world, box({1.0 * i, -0.5, 0}, {0.5, 0.5, 5}, 0));
    }
    const std::size_t i = add(world, shot({0.3, 0.25, 0}, 0.25, {speed, 0, 0}));
    world.bodies[i].friction = 0;
    run(world, 45 / speed);
    REQUIRE(world.bodies[i].motion.velocity.x() == Approx(speed).epsilon(1e-9));
    REQUIRE(std::abs(world.bodies[i].motion.center.y() - 0.25) < 0.001);
  }
}
// [seams]

TEST_CASE("a pyramid 500 km from the origin stands as it does there, to 1e-6 m")
{
  World world = pyramid<World>(5), remote = pyramid<World>(5);
  const Vector3<double> place{3e5, 0, -4e5};
  for (RigidBody& body : remote.bodies)
  {
    body.motion.center += place;
  }
  run(world, 3);
  run(remote, 3);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    const Vector3<double> there = remote.bodies[i].motion.center - place;
    REQUIRE((there - world.bodies[i].motion.center).norm() < 1e-6);
  }
}

TEST_CASE("a pyramid on ground that moves at 100 m/s stands, and moves with it")
{
  World world = pyramid<World>(5);
  for (RigidBody& body : world.bodies)
  {
    body.motion.velocity.x() = 100;
  }
  const World start = world;
  run(world, 5);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    const Vector3<double> moved = world.bodies[i].motion.center - start.bodies[i].motion.center;
    REQUIRE((moved - Vector3<double>(500, 0, 0)).norm() < 0.01);
  }
}

TEST_CASE("a world that is turned, gravity too, moves alike, turned")
{
  const Quaternion<double> turn(Eigen::AngleAxisd(1, Vector3<double>(1, 2, 3).normalized()));
  World world = ground<World>(), other;
  other.gravity = turn * world.gravity;
  add(world, turned(box({0, 2, 0}, {0.5, 0.3, 0.2}, 1), 0.7, {1, 0, 0.6}));
  for (RigidBody body : world.bodies)
  {
    body.motion.center = turn * body.motion.center;
    set_orientation(body, turn * body.orientation);
    add(other, body);
  }
  run(world, 0.75); // it has landed on a corner and topples
  run(other, 0.75);
  const Vector3<double> center = turn * world.bodies[1].motion.center;
  REQUIRE((other.bodies[1].motion.center - center).norm() < 1e-6);
}

TEST_CASE("without gravity a sphere drifts at 4 cm/s for ten seconds, 0.4 m far")
{
  World world = space();
  add(world, shot({0, 0, 0}, 0.5, {0.04, 0, 0}));
  run(world, 10);
  REQUIRE(world.bodies[0].motion.center.x() == Approx(0.4).epsilon(1e-9));
}

TEST_CASE("under a gravity of 0.05 m/s² a body that starts at rest falls, and sleeps on the ground")
{
  World world = ground<World>();
  world.gravity.y() = -0.05;
  add(world, sphere({0, 1.1, 0}, 0.1, 1));
  run(world, 4); // it falls 0.4 m
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.7).epsilon(0.001));
  run(world, 6);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.1).epsilon(0.001));
  REQUIRE(sleepers(world) == 1);
}

TEST_CASE("an hour of sleep changes no bit", "[long]")
{
  World world = tower<World>(5);
  run(world, 5);
  REQUIRE(sleepers(world) == 5);
  const World start = world;
  run(world, 3600);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
  {
    REQUIRE(world.bodies[i].motion.center == start.bodies[i].motion.center);
    REQUIRE(world.bodies[i].orientation.coeffs() == start.bodies[i].orientation.coeffs());
  }
}

TEST_CASE("a cube carries one of ten and of a hundred times its mass")
{
  for (const double ratio : {10.0, 100.0})
  {
    World world = tower<World>(1);
    add(world, box({0, 1.5, 0}, {0.5, 0.5, 0.5}, ratio));
    run(world, 20);
    REQUIRE(world.bodies[2].motion.center.y() > 1.45);
    REQUIRE(sleepers(world) == 2);
  }
}

TEST_CASE("bodies ride on a lift up and down, and wake as it sets off")
{
  World world = tower<World>(2);
  run(world, 2);
  REQUIRE(sleepers(world) == 2);
  for (const double speed : {1.0, -1.0})
  {
    world.bodies[0].motion.velocity.y() = speed;
    run(world, 3);
    const double top = world.bodies[0].motion.center.y() + 1;
    REQUIRE(world.bodies[1].motion.center.y() - top == Approx(0.5).margin(0.005));
    REQUIRE(world.bodies[2].motion.center.y() - top == Approx(1.5).margin(0.005));
  }
}

TEST_CASE("a belt of 2 m/s takes a cube along after it has slipped v² / (2 μ g); R6")
{
  World world = tower<World>(1);
  run(world, 2);
  world.bodies[0].motion.velocity.x() = 2;
  run(world, 3);
  const double right = 6 - 4 / (2 * 0.6 * 9.81);
  REQUIRE(world.bodies[1].motion.center.x() == Approx(right).epsilon(0.01));
}

TEST_CASE("a cube rides on a turntable for a turn, and creeps outwards by less than 3 cm")
{
  World world = ground<World>();
  world.bodies[0].motion.angular_velocity.y() = 1;
  add(world, box({0.3, 0.5, 0}, {0.2, 0.5, 0.2}, 1));
  run(world, 2 * std::numbers::pi);
  const Vector3<double>& center = world.bodies[1].motion.center;
  REQUIRE(std::hypot(center.x(), center.z()) == Approx(0.3).margin(0.03));
}

TEST_CASE(
    "fifty boxes that are dropped into a pit all sleep within 20 s, and none leaves it", "[long]")
{
  World world = ground<World>();
  for (const Vector3<double>& side : {Vector3<double>(1, 0, 0), Vector3<double>(0, 0, 1)})
  {
    const Vector3<double> half_extents{3 - 2.5 * side.x(), 4, 3 - 2.5 * side.z()};
    add(world, box(3.5 * side + Vector3<double>(0, 3, 0), half_extents, 0));
    add(world, box(-3.5 * side + Vector3<double>(0, 3, 0), half_extents, 0));
  }
  Random random(7);
  for (int i = 0; i < 50; ++i)
  {
    const Vector3<double> place = random.in_cube(2);
    RigidBody body = box({place.x(), 1 + 0.8 * i, place.z()}, {0.4, 0.3, 0.5}, 1);
    add(world, turned(body, 3, random.direction()));
  }
  run(world, 20);
  REQUIRE(sleepers(world) == 50);
  for (std::size_t i = 5; i < world.bodies.size(); ++i)
  {
    const Vector3<double>& center = world.bodies[i].motion.center;
    REQUIRE(center.y() > 0.29);
    REQUIRE(std::max(std::abs(center.x()), std::abs(center.z())) < 3);
  }
}

TEST_CASE("a sphere rolls down a slope of 10 degrees with 5/7 of the acceleration, within 1 %")
{
  World world = ground<World>();
  const double slope = std::numbers::pi / 18;
  world.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope), 0};
  add(world, sphere({0, 0.5, 0}, 0.5, 1));
  run(world, 3);
  const double right = 5.0 / 7 * 9.81 * std::sin(slope) * 4.5; // a t² / 2
  REQUIRE(world.bodies[1].motion.center.x() == Approx(right).epsilon(0.01));
}

TEST_CASE("a tower of ten cubes of 10 cm falls at 60 steps a second and stands at 240")
{
  for (const double rate : {60.0, 240.0})
  {
    World world = ground<World>();
    for (int i = 0; i < 10; ++i)
    {
      add(world, box({0, 0.1 * i + 0.05, 0}, {0.05, 0.05, 0.05}, 1));
    }
    for (int i = 0; i < static_cast<int>(20 * rate); ++i)
    {
      step(world, 1 / rate);
    }
    REQUIRE((world.bodies[10].motion.center.y() > 0.9) == (rate == 240));
  }
}

TEST_CASE("a sphere that spins upright spins for ever: at one point nothing resists a twist")
{
  World world = ground<World>();
  add(world, sphere({0, 0.5, 0}, 0.5, 1));
  world.bodies[1].motion.angular_velocity.y() = 10;
  run(world, 20);
  REQUIRE(world.bodies[1].motion.angular_velocity.y() == Approx(10).epsilon(1e-6));
  REQUIRE(sleepers(world) == 0);
}

TEST_CASE("a sleeping cube follows a floor that sinks at 1 m/s")
{
  World world = tower<World>(1);
  run(world, 3);
  REQUIRE(sleepers(world) == 1);
  world.bodies[0].motion.velocity.y() = -1;
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(-0.5).margin(0.005));
}

TEST_CASE("what lies on a sleeping cube falls once that is moved away and woken, or kicked")
{
  for (const bool kicked : {false, true})
  {
    World world = tower<World>(2);
    run(world, 3);
    REQUIRE(sleepers(world) == 2);
    if (kicked)
    {
      world.bodies[1].motion.velocity.x() = 8;
    }
    else
    {
      world.bodies[1].motion.center.x() = 3;
      small_world::wake(world, 1);
    }
    run(world, 3);
    REQUIRE(world.bodies[1].motion.center.x() > 2);
    REQUIRE(world.bodies[2].motion.center.y() == Approx(0.5).margin(0.001));
    REQUIRE(sleepers(world) == 2);
  }
}

TEST_CASE("a sleeping tower that is woken stands on its contacts at once, each of them once")
{
  for (const bool by_lift : {false, true})
  {
    World world = tower<World>(5);
    run(world, 3);
    REQUIRE(sleepers(world) == 5);
    const std::size_t contacts = world.asleep.size();
    const double speed = by_lift ? 0.01 : 0;
    world.bodies[0].motion.velocity.y() = speed;
    small_world::wake(world, 3);
    step(world, frame);
    REQUIRE(world.asleep.empty());
    REQUIRE(world.contacts.size() == contacts);
    for (const RigidBody& body : world.bodies)
    {
      REQUIRE(std::abs(body.motion.velocity.y() - speed) < 0.02); // without contacts: g h = 0.16
    }
  }
}

TEST_CASE("a shot wakes a sleeping tower")
{
  World world = tower<World>(5);
  run(world, 3);
  REQUIRE(sleepers(world) == 5);
  add(world, shot({-5, 2.5, 0}, 0.2, {40, 0, 0}));
  run(world, 0.3);
  REQUIRE(sleepers(world) == 0);
}

TEST_CASE("a heap without gravity and ground keeps its momentum, and gains no energy")
{
  World world = space();
  for (int i = 0; i < 27; ++i)
  {
    const Vector3<double> place{1.5 * (i % 3 - 1), 1.5 * (i / 3 % 3 - 1), 1.5 * (i / 9 - 1)};
    RigidBody body = i % 2 == 0 ? sphere(place, 0.5, 1) : box(place, {0.5, 0.4, 0.3}, 2);
    body.motion.velocity = -place;
    body.motion.angular_velocity = place.reverse();
    body.restitution = 0.5;
    add(world, body);
  }
  world.bodies[0].motion.velocity.x() += 1;
  const Vector3<double> before = momentum_of(world);
  double energy = energy_of(world);
  for (int i = 0; i < 300; ++i)
  {
    step(world, frame);
    REQUIRE((momentum_of(world) - before).norm() < 1e-9);
    REQUIRE(energy_of(world) < energy * (1 + 1e-3));
    energy = energy_of(world);
  }
}

TEST_CASE("bodies that overlap at the start come out at less than 3 m/s")
{
  for (const double depth : {0.1, 0.5, 0.9})
  {
    World world = ground<World>();
    add(world, cube({0, 0.5 - depth, 0}));
    for (int i = 0; i < 600; ++i)
    {
      step(world, frame);
      REQUIRE(world.bodies[1].motion.velocity.norm() < 3);
    }
    REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5).margin(0.001));
  }
}

TEST_CASE("two bodies in one place separate: boxes, and spheres")
{
  for (const bool is_sphere : {false, true})
  {
    World world = ground<World>();
    for (int i = 0; i < 2; ++i)
    {
      add(world, is_sphere ? sphere({0, 0.5, 0}, 0.5, 1) : cube({0, 0.5, 0}));
    }
    run(world, 5);
    const Vector3<double> apart = world.bodies[2].motion.center - world.bodies[1].motion.center;
    REQUIRE(apart.norm() > 0.99);
  }
}

TEST_CASE("a box that spins at 10 to 10,000 rad/s comes down with no more energy than it had")
{
  for (const double spin : {10.0, 100.0, 1000.0, 9990.0})
  {
    World world = ground<World>();
    RigidBody body = box({0, 1, 0}, {0.5, 0.3, 0.2}, 1);
    body.motion.angular_velocity = {0, spin, 0.01 * spin};
    body.restitution = 0.5;
    add(world, body);
    const double energy = energy_of(world);
    for (int i = 0; i < 600; ++i)
    {
      step(world, frame);
      REQUIRE(energy_of(world) < energy * (1 + 1e-3));
    }
  }
}

TEST_CASE("bodies of 1 cm to 10 m come to rest on a face, sunk by less than 3 % of their size")
{
  for (const double size : {0.01, 0.1, 1.0, 10.0})
  {
    World world = ground<World>();
    const Vector3<double> half_extents = Vector3<double>::Constant(0.5 * size);
    const double mass = 1000 * size * size * size;
    add(world, turned(box({0, 2 * size, 0}, half_extents, mass), 0.7, {1, 0, 0.6}));
    run(world, 10);
    REQUIRE(world.bodies[1].motion.center.y() / size == Approx(0.5).margin(0.03));
    REQUIRE(sleepers(world) == 1);
  }
}

TEST_CASE("a gravity that is none, or more than 10 km/s², is refused before anything moves")
{
  World world = tower<World>(1);
  world.gravity.y() = std::numeric_limits<double>::quiet_NaN();
  REQUIRE_THROWS_WITH(
      step(world, frame), "gravity.norm() is nan; it must be from 0.000000 to 10000.000000");
  world.gravity.y() = -1e5;
  REQUIRE_THROWS(step(world, frame));
  REQUIRE(world.bodies[1].motion.center.y() == 0.5);
}

// [limit_of_step_4]
TEST_CASE("sort and sweep compares all pairs of a wall across x, and 160 of a row along it")
{
  small_world::step_4::World wall = ground<small_world::step_4::World>();
  small_world::step_4::World row = ground<small_world::step_4::World>();
  for (int i = 0; i < 400; ++i)
  {
    add(wall, cube({0, i / 20 + 0.5, 1.1 * (i % 20)}));
  }
  for (int i = 0; i < 160; ++i)
  {
    add(row, cube({1.1 * (i - 80), 0.5, 0}));
  }
  REQUIRE(pairs_compared(wall.bodies) == 401 * 400 / 2);
  REQUIRE(pairs_compared(row.bodies) == 160); // each with the ground
}
// [limit_of_step_4]

TEST_CASE("a floor of n² cubes takes n² + n · n (n - 1) / 2 comparisons: n columns along z")
{
  for (const std::size_t n : {5U, 10U, 20U})
  {
    const auto world = floor_of_cubes<small_world::step_4::World>(static_cast<int>(n));
    REQUIRE(pairs_compared(world.bodies) == n * n + n * n * (n - 1) / 2);
  }
}

// [limits_of_step_5]
TEST_CASE("a sphere dropped from 5 mm at e = 0.5 stays down; from 20 mm it bounces")
{
  REQUIRE(height_of_bounce(dropped_sphere<small_world::step_5::World>(0.005, 0.5), 0.4) < 1e-4);
  REQUIRE(
      height_of_bounce(dropped_sphere<small_world::step_5::World>(0.02, 0.5), 0.2) ==
      Approx(0.005).epsilon(0.1));
}

TEST_CASE("a row of spheres at e = 1 passes a velocity on across 1 mm, but not where it touches")
{
  for (const double gap : {0.001, 0.0})
  {
    World world = space();
    for (int i = 0; i < 5; ++i)
    {
      add(world, shot({i * (0.1 + gap), 0, 0}, 0.05, {0, 0, 0}));
    }
    add(world, shot({-1, 0, 0}, 0.05, {2, 0, 0}));
    for (RigidBody& body : world.bodies)
    {
      body.restitution = 1;
    }
    run(world, 2);
    const double first = world.bodies[5].motion.velocity.x();
    const double last = world.bodies[4].motion.velocity.x();
    const bool right = std::abs(first) < 1e-9 && std::abs(last - 2) < 1e-9;
    REQUIRE(right == (gap > 0));
  }
}
// [limits_of_step_5]

// [limits_of_step_6]
TEST_CASE("a cube on its edge, tilted by 0.001, falls over in step 5, and falls asleep in step 6")
{
  const RigidBody tilted =
      turned(cube({0, std::sqrt(0.5), 0}), std::numbers::pi / 4 + 0.001, Vector3<double>::UnitZ());
  auto world = ground<small_world::step_5::World>();
  auto sleeping = ground<small_world::step_6::World>();
  add(world, tilted);
  add(sleeping, tilted);
  run(world, 10);
  run(sleeping, 10);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5).margin(0.001));
  REQUIRE(sleeping.bodies[1].motion.center.y() > 0.7);
}

TEST_CASE("a cube that sets off down a slope at 0.05 m/s² slides 2.5 m in 10 s; step 6 stops it")
{
  const double slope = std::atan(0.6) + 0.05 / 9.81 * std::cos(std::atan(0.6));
  const auto slid = [&](auto world)
  {
    world.gravity = {9.81 * std::sin(slope), -9.81 * std::cos(slope), 0};
    add(world, cube({0, 0.5, 0}));
    run(world, 10);
    return world.bodies[1].motion.center.x();
  };
  const double right = 50 * 9.81 * (std::sin(slope) - 0.6 * std::cos(slope)); // a t² / 2
  REQUIRE(slid(ground<small_world::step_5::World>()) == Approx(right).epsilon(0.05));
  REQUIRE(slid(ground<small_world::step_6::World>()) < 0.02);
}

TEST_CASE("a change of gravity wakes nothing; wake() does")
{
  World world = tower<World>(1);
  run(world, 3);
  world.gravity = {9.81, 0, 0};
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.x() < 1e-3);
  small_world::wake(world, 1);
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.x() == Approx(4.905).epsilon(0.05)); // g t² / 2
}

TEST_CASE("a sleeping cube stays in the air where the ground is put away, until it is woken")
{
  World world = tower<World>(1);
  run(world, 3);
  world.bodies[0].motion.center.y() -= 10;
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5).margin(0.001));
  small_world::wake(world, 1);
  run(world, 1);
  REQUIRE(world.bodies[1].motion.center.y() == Approx(0.5 - 4.905).epsilon(0.05)); // g t² / 2
}
// [limits_of_step_6]

// [limits_of_step_7]
TEST_CASE("a box of 10 cm passes a wall of 2 cm at 30 m/s, and so does a thin bat past a sphere")
{
  World world = space();
  add(world, box({0, 0, 0}, {0.01, 5, 5}, 0));
  add(world, box({-2, 0, 0}, {0.05, 0.05, 0.05}, 1));
  world.bodies[1].motion.velocity.x() = 30;
  run(world, 0.5);
  REQUIRE(world.bodies[1].motion.velocity.x() == 30);
  World other = space();
  add(other, box({-2.1, 0, 0}, {0.01, 0.5, 0.5}, 0));
  other.bodies[0].motion.velocity.x() = 100;
  add(other, sphere({0, 0, 0}, 0.05, 1));
  run(other, 0.5);
  REQUIRE(other.bodies[1].motion.velocity.x() == 0);
}

TEST_CASE("a shot at 10 to 1,000 m/s comes back later than it should, by less than two frames")
{
  for (const double speed : {10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    World world = shot_at_wall<World>(speed);
    run(world, 1);
    const double time = 1.94 / speed; // [s], until it touches the wall at x = -0.06
    const double right = -0.06 - 0.5 * speed * (1 - time);
    const double late = (world.bodies[1].motion.center.x() - right) / (0.5 * speed);
    REQUIRE(late > 0);
    REQUIRE(late < 2 * frame);
  }
}
// [limits_of_step_7]

// [spin_is_left_out]
TEST_CASE("a book that tumbles freely keeps its angular velocity, and not its angular momentum")
{
  World world = space();
  RigidBody book = box({0, 0, 0}, {0.1, 0.02, 0.15}, 1);
  book.motion.angular_velocity = {1, 5, 5};
  add(world, book);
  const auto momentum = [&]
  {
    const RigidBody& body = world.bodies[0];
    const Vector3<double> own = body.orientation.conjugate() * body.motion.angular_velocity;
    return Vector3<double>(body.orientation * body.moments.cwiseProduct(own));
  };
  const Vector3<double> start = momentum();
  double farthest = 0;
  for (int i = 0; i < 60; ++i)
  {
    step(world, frame);
    farthest = std::max(farthest, (momentum() - start).norm() / start.norm());
  }
  REQUIRE(world.bodies[0].motion.angular_velocity == Vector3<double>(1, 5, 5));
  REQUIRE(farthest > 0.2); // right: 0
}
// [spin_is_left_out]

// [plain_sweep]
TEST_CASE("step 7's first touch with a box is the hardened sweep's, to the thousandth it stops at")
{
  Random random(7);
  int hits = 0;
  for (int i = 0; i < inputs(20'000, 1'000); ++i)
  {
    RigidBody target = box(random.in_cube(0.5), {0.3, 0.5, 0.8}, 0);
    const Vector3<double> v = random.direction();
    set_orientation(target, Quaternion<double>(1, v.x(), v.y(), v.z()));
    const Sphere<double> start{4 * random.direction(), 0.2}, larger{start.center, 0.2002};
    const Vector3<double> displacement = -2 * start.center + random.in_cube(2);
    const auto plain = step_7::first_touch(start, displacement, target);
    const auto touch = swept_sphere_box(start, displacement, box_of(target));
    const auto early = swept_sphere_box(larger, displacement, box_of(target));
    if (touch)
    {
      REQUIRE(plain.has_value());
      REQUIRE(plain->time <= touch->time + 1e-12);
      ++hits;
    }
    if (plain)
    {
      REQUIRE(early.has_value());
      REQUIRE(plain->time >= early->time - 1e-12);
    }
  }
  REQUIRE(hits > inputs(5'000, 250));
}
// [plain_sweep]
