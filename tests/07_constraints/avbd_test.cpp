/// \file
/// Augmented vertex block descent: one particle, one update, a cable, chains, friction, momentum.

#include "07_constraints/avbd/trial/avbd_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <vector>

using namespace cookbook;

// [R68]
TEST_CASE("a particle settles between inertia of 100 N/m and a rod of 1,000 N/m", "[R68]")
{
  Particles two{{{0, 0, 0}, {0, -1.1, 0}}, {{0, 0, 0}, {0, 0, 0}}, {0, 1}};
  const std::vector<DistanceConstraint> rod{{0, 1, 1.0}};
  const std::vector<AvbdMemory> memories{{0, 1000}};
  const Vector3<double> alone = two.positions[1];
  settle_particle(
      two, 1, alone, two.positions, rod, memories, {.stabilization = 0}, 0.1); // 1 kg / h² = 100
  CHECK(two.positions[1].y() == Catch::Approx(-(100 * 1.1 + 1000 * 1.0) / 1100).epsilon(1e-12));
  CHECK(two.positions[1].x() == 0);
}
// [R68]

// [R69]
TEST_CASE("a push takes over what the spring bears, and the spring grows by its error", "[R69]")
{
  AvbdMemory memory{.push = 5, .stiffness = 100};
  update(memory, -0.01, {.growth = 1000});
  CHECK(memory.push == Catch::Approx(6));
  CHECK(memory.stiffness == Catch::Approx(110));
  update(memory, 1e9, {.growth = 1000, .most = 500});
  CHECK(memory.stiffness == 500);
}
// [R69]

// [avbd_cable]
TEST_CASE(
    "a cable hangs within .1 mm with 50 passes and fast growth, by 50 mm off with 10", "[long]")
{
  CHECK(cable_off({.iterations = 50, .growth = 1e6}) <= 1e-4);
  CHECK(cable_off({}) >= 0.05);
}
// [avbd_cable]

// [avbd_chain]
TEST_CASE(
    "1,000 kg on a chain, pushed aside at .5 m/s, stay on it with ten passes, not with five",
    "[long]")
{
  const auto stays = [](int passes)
  {
    GameWorld world = world_of(TrialChain{.load = 1000}, one_by_one(Avbd({.iterations = passes})));
    world.set_velocity(10, {0.5, 0, 0}, {0, 0, 0});
    double lowest = 0;
    for (int step = 0; step < 300; ++step)
    {
      world.step();
      lowest = std::min(lowest, world.body(21).motion.center.y() - 9.75);
    }
    return lowest >= -4 && !is_fixed(world.body(21)); // a world fixes what has overflowed
  };
  CHECK(stays(10));
  CHECK_FALSE(stays(5));
}

TEST_CASE(
    "a tower of ten sinks by less than 1 cm in 10 s; one of five flies where growth is fast",
    "[long]")
{
  CHECK(std::abs(tower_sink(10, {})) <= 0.01);
  CHECK(std::abs(tower_sink(5, {.growth = 1e5})) > 1);
}
// [avbd_chain]

// [avbd_friction]
TEST_CASE("a cube on a slope of .5 rad slides 5 % below the friction that holds it, not above")
{
  for (const double share : {0.95, 1.05})
  {
    Scene scene{.gravity = {9.81 * std::sin(0.5), -9.81 * std::cos(0.5), 0}};
    scene.bodies = {ground(), cube_body("cube", {0, 0.5, 0})};
    scene.bodies[0].friction = scene.bodies[1].friction = share * std::tan(0.5);
    GameWorld world(scene, one_by_one(Avbd()));
    for (int step = 0; step < 120; ++step)
    {
      world.step();
    }
    const double slid = world.body(1).motion.center.x();
    CAPTURE(share, slid);
    CHECK((share < 1 ? slid > 0.3 : slid < 0.05));
  }
}
// [avbd_friction]

// [avbd_momentum]
TEST_CASE("two bodies on a joint in space drift: ten passes do not keep their momentum", "[long]")
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {
      box_body("one", {0.1, 0.2, 0.3}, {0, 0, 0}, 1),
      box_body("other", {0.1, 0.5, 0.1}, {1, 0, 0}, 3)};
  scene.bodies[0].velocity = {1, 0, 0};
  scene.bodies[1].velocity = {0, 1, 0};
  const auto drift = [&](int passes)
  {
    GameWorld world(scene, one_by_one(Avbd({.iterations = passes})));
    BallJoints joints;
    joints.add(ball_joint_at(world, 0, 1, {0.5, 0.1, 0}));
    world.add(joints);
    for (int step = 0; step < 120; ++step)
    {
      world.step();
    }
    const Vector3<double> momentum =
        world.body(0).motion.velocity + 3 * world.body(1).motion.velocity;
    return (momentum - Vector3<double>(1, 3, 0)).norm();
  };
  CHECK(drift(10) > 1e-3);
  CHECK(drift(200) < drift(10) / 10);
}
// [avbd_momentum]
