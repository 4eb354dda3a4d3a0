/// \file
/// Ball joints, and with them any constraints beside contacts: periods, loads, momentum, sleep,
/// copies.

#include "06_world/ball_joint/ball_joint.hpp"
#include "06_world/ball_joint/trial/joint_pendulum.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

using namespace cookbook;

namespace
{

const std::vector<std::string> jointed_solvers{
    "direct", "soft_steps", "wide_steps", "sequential_impulses"};

/// Links of 1 kg and 1 m that hang on each other and on a hook, at y = 20 m.
GameWorld chain(int links, const std::string& solver)
{
  Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 20, 0}, 0)}};
  for (int i = 0; i < links; ++i)
  {
    scene.bodies.push_back(box_body("link", {0.1, 0.5, 0.1}, {0, 19.5 - i, 0}));
  }
  GameWorld world(scene, solver_named(solver));
  BallJoints joints;
  for (int i = 0; i < links; ++i)
  {
    const auto upper = static_cast<BodyId>(i);
    joints.add(ball_joint_at(world, upper, upper + 1, {0, 20.0 - i, 0}));
  }
  world.add(joints);
  return world;
}

/// Two boxes in space that turn about a point between them.
GameWorld tumbling_pair(const std::string& solver)
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {
      box_body("one", {0.1, 0.2, 0.3}, {0, 0, 0}, 1),
      box_body("other", {0.1, 0.5, 0.1}, {1, 0, 0}, 3)};
  scene.bodies[0].velocity = {1, 0, 0};
  scene.bodies[0].angular_velocity = {0, 2, 1};
  scene.bodies[1].velocity = {0, 1, 0};
  scene.bodies[1].angular_velocity = {3, 0, 1};
  GameWorld world(scene, solver_named(solver));
  BallJoints joints;
  joints.add(ball_joint_at(world, 0, 1, {0.5, 0.1, 0}));
  world.add(joints);
  return world;
}

/// Linear [kg m/s] and angular momentum [kg m²/s] of all bodies, and their energy [J].
struct Balance
{
  Vector3<double> linear = Vector3<double>::Zero(), angular = Vector3<double>::Zero();
  double energy = 0;
};

Balance balance_of(const GameWorld& world)
{
  const std::vector<RigidBody>& bodies = world.bodies();
  return {momentum(bodies), angular_momentum(bodies), energy(bodies, world.scene().gravity)};
}

void step(GameWorld& world, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
}

} // namespace

// [R36]
TEST_CASE("a pendulum that swings by 28 and 86° has the period of the elliptic integral", "[R36]")
{
  for (const double amplitude : {0.5, 1.5})
  {
    CAPTURE(amplitude);
    const Swing direct = swing_of({.solver = "direct", .rate = 60, .amplitude = amplitude});
    CHECK(direct.period == Catch::Approx(direct.right).epsilon(1e-5));
    for (const std::string solver : {"soft_steps", "wide_steps"})
    {
      CAPTURE(solver);
      const Swing soft = swing_of({.solver = solver, .rate = 60, .amplitude = amplitude});
      CHECK(soft.period == Catch::Approx(soft.right).epsilon(1e-3));
    }
  }
}

TEST_CASE("a pendulum keeps its energy to 1 % for 20 s, and its anchors within .2 mm", "[R36]")
{
  for (const std::string solver : {"soft_steps", "wide_steps"})
  {
    const Swing swing = swing_of({.solver = solver, .rate = 60, .amplitude = 1.5});
    CAPTURE(solver);
    CHECK(swing.least >= -0.01 * swing.swings_up);
    CHECK(swing.most <= 0.01 * swing.swings_up);
    CHECK(swing.apart <= 2e-4);
  }
  const Swing direct = swing_of({.solver = "direct", .rate = 60, .amplitude = 1.5});
  CHECK(direct.least >= -0.01 * direct.swings_up);
  CHECK(direct.most <= 0.01 * direct.swings_up);
  CHECK(direct.apart <= 2e-4);
}
// [R36]

// [chain]
TEST_CASE("in a chain of ten links the k-th joint carries what hangs below it, to nine digits")
{
  GameWorld world = chain(10, "direct");
  step(world, 600);
  const BallJoints& joints = world.constraints<BallJoints>(0);
  for (std::size_t i = 0; i < joints.size(); ++i)
  {
    const double below = static_cast<double>(joints.size() - i) * 9.81;
    CHECK(joints.impulses(i)[1] / world.scene().step == Catch::Approx(below).epsilon(1e-9));
  }
  CHECK(std::abs(world.body(10).motion.center.y() - 10.5) <= 1e-7);
}
// [chain]

TEST_CASE("a chain of ten hangs under all solvers, and gives way by less than 1 cm")
{
  for (const std::string& solver : solver_names())
  {
    GameWorld world = chain(10, solver);
    step(world, 600);
    CAPTURE(solver);
    CHECK(std::abs(world.body(10).motion.center.y() - 10.5) <= 0.01);
  }
}

// [joint_momentum]
TEST_CASE("two bodies in space keep their momenta to rounding whatever a joint does", "[R36]")
{
  for (const std::string& solver : jointed_solvers)
  {
    GameWorld world = tumbling_pair(solver);
    step(world, 1); // which brings the anchors together
    const Balance before = balance_of(world);
    step(world, 600);
    const Balance after = balance_of(world);
    CAPTURE(solver);
    CHECK((after.linear - before.linear).norm() <= 1e-12 * before.linear.norm());
    CHECK((after.angular - before.angular).norm() <= 1e-12 * before.angular.norm());
    const bool relaxes = solver == "soft_steps" || solver == "wide_steps";
    CHECK(after.energy == Catch::Approx(before.energy).epsilon(relaxes ? 1e-3 : 0.02));
  }
}
// [joint_momentum]

TEST_CASE("a pair on a joint and a pendulum, copied, go on to the bit")
{
  for (const std::string& solver : solver_names())
  {
    GameWorld world = tumbling_pair(solver);
    step(world, 30);
    GameWorld copy = world;
    step(world, 100);
    step(copy, 100);
    for (std::size_t i = 0; i < 2; ++i)
    {
      CHECK(world.bodies()[i].motion.center == copy.bodies()[i].motion.center);
      CHECK(world.bodies()[i].orientation.coeffs() == copy.bodies()[i].orientation.coeffs());
    }
  }
}

TEST_CASE("a world with a set of no joints has the same bits as one without", "[long]")
{
  for (const std::string& solver : solver_names())
  {
    GameWorld without(named_scene("pile_60"), solver_named(solver));
    GameWorld with = without;
    with.add(BallJoints());
    step(without, 60);
    step(with, 60);
    for (std::size_t i = 0; i < with.bodies().size(); ++i)
    {
      CHECK(with.bodies()[i].motion.center == without.bodies()[i].motion.center);
    }
  }
}

// [joined_islands]
TEST_CASE("two cubes 3 m apart on one joint sleep as one island, and wake as one")
{
  Scene scene{
      .bodies = {ground(), cube_body("left", {-1.5, 0.5, 0}), cube_body("right", {1.5, 0.5, 0})}};
  GameWorld world(scene, solver_named("direct"), true);
  BallJoints joints;
  joints.add(ball_joint_at(world, 1, 2, {0, 0.5, 0}));
  world.add(joints);
  step(world, 120);
  CHECK(world.is_asleep(1));
  CHECK(world.is_asleep(2));
  world.set_velocity(1, {0, 0, 1}, {0, 0, 0});
  CHECK_FALSE(world.is_asleep(2));
}
// [joined_islands]

TEST_CASE("bodies of a joint pass through each other, unless it says that they touch")
{
  for (const bool collides : {false, true})
  {
    Scene scene{
        .gravity = {0, 0, 0},
        .bodies = {cube_body("one", {0, 0, 0}), cube_body("other", {0.5, 0, 0})}};
    GameWorld world(scene, solver_named("soft_steps"));
    BallJoint joint = ball_joint_at(world, 0, 1, {0.25, 0, 0});
    joint.collides = collides;
    BallJoints joints;
    joints.add(joint);
    world.add(joints);
    step(world, 1);
    CHECK(world.contacts().empty() != collides);
  }
}

TEST_CASE("a joint goes with its body; one of a body that is not there is refused")
{
  GameWorld world = chain(2, "direct");
  world.remove(1);
  CHECK(world.constraints<BallJoints>(0).size() == 0);
  step(world, 60);
  CHECK(world.body(2).motion.center.y() < 18); // it falls
  BallJoints of_none;
  of_none.add({0, 7, {0, 0, 0}, {0, 0, 0}});
  CHECK_THROWS_AS(world.add(of_none), std::out_of_range);
  step(world, 1);
}

TEST_CASE("a kinematic hook carries a lamp along at 1 m/s")
{
  for (const std::string& solver : jointed_solvers)
  {
    Scene scene{
        .bodies = {
            box_body("hook", {0.1, 0.1, 0.1}, {0, 5, 0}, 1), ball_body("lamp", 0.1, {0, 4, 0})}};
    scene.bodies[0].motion = MotionType::kinematic;
    scene.bodies[0].velocity = {0, 1, 0};
    GameWorld world(scene, solver_named(solver), true);
    BallJoints joints;
    joints.add(ball_joint_at(world, 0, 1, {0, 5, 0}));
    world.add(joints);
    step(world, 300);
    CAPTURE(solver);
    CHECK(world.body(1).motion.center.y() == Catch::Approx(9).margin(0.01));
  }
}

TEST_CASE("position_based refuses constraints that cannot correct positions, by their name")
{
  struct Stiff : BallJoints
  {
    std::unique_ptr<ConstraintSet> clone() const override { return std::make_unique<Stiff>(*this); }
    const char* name() const override { return "stiff joints"; }
    bool correct(Bodies, int, double, bool) override { return false; }
  };
  GameWorld world(tumbling_pair("position_based").scene(), solver_named("position_based"));
  Stiff joints;
  joints.add(ball_joint_at(world, 0, 1, {0.5, 0.1, 0}));
  world.add(joints);
  CHECK_THROWS_WITH(
      world.step(), "stiff joints have no correct(): position_based cannot solve them");
}
