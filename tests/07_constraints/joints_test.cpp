/// \file
/// Joints in the world: hinges, sliders, welds, wheels and the others against statics and closed
/// forms, under all solvers; momentum, copies, breaking.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "07_constraints/joints/joints.hpp"
#include "07_constraints/joints/trial/door.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

const double pi = std::numbers::pi, g = 9.81;

/// Calls step() so many times.
void step(GameWorld& world, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
}

/// A world of a post that stays at the origin and other bodies.
GameWorld world_of(const std::string& solver, std::vector<SceneBody> bodies, double gravity = g)
{
  Scene scene{.gravity = {0, -gravity, 0}};
  scene.bodies = {box_body("post", {0.05, 0.05, 0.05}, {0, 0, 0}, 0)};
  scene.bodies.insert(scene.bodies.end(), bodies.begin(), bodies.end());
  return GameWorld(scene, solver_named(solver));
}

/// The same with one joint between the post and the next body.
template <class Kind>
GameWorld with_joint(GameWorld world, const Kind& joint)
{
  JointSet<Kind> joints;
  joints.add(joint);
  world.add(joints);
  return world;
}

/// The first joint of the first set.
template <class Kind>
const Kind& joint_of(GameWorld& world)
{
  return world.constraints<JointSet<Kind>>(0)[0];
}

/// How the frames of the first joint lie.
template <class Kind>
FramePose pose_in(GameWorld& world)
{
  const Kind& joint = joint_of<Kind>(world);
  return frame_pose(world.body(0), world.body(1), joint.frame_a, joint.frame_b);
}

/// A beam of 2 kg and 1 m along x on a hinge about z at the origin.
GameWorld beam(const std::string& solver, const JointDrive& drive)
{
  GameWorld world = world_of(solver, {box_body("beam", {0.5, 0.05, 0.05}, {0.5, 0, 0}, 2)});
  HingeJoint hinge = hinge_at(world, 0, 1, {0, 0, 0}, {0, 0, 1});
  hinge.drive = drive;
  return with_joint(world, hinge);
}

} // namespace

// [door]
TEST_CASE("a door that hits its limit with 10 rad/s stops there, where engines rebound", "[R57]")
{
  const DoorEnd direct = end_of_door("direct");
  CHECK(direct.overshoot <= 1e-9);
  CHECK(direct.rebound <= 2e-5);
  for (const std::string solver : {"soft_steps", "wide_steps"})
  {
    const DoorEnd soft = end_of_door(solver);
    CHECK(soft.overshoot == 0);
    CHECK(soft.rebound <= 1e-12);
  }
  const DoorEnd positions = end_of_door("position_based");
  CHECK(positions.overshoot <= 1e-9);
  CHECK(positions.rebound <= 1e-3);
  const DoorEnd sequential = end_of_door("sequential_impulses"); // 8 passes in one step
  CHECK(sequential.overshoot <= 2e-3);
  CHECK(sequential.rebound <= 0.05);
}
// [door]

// [hinge_axis]
TEST_CASE(
    "a hinge that swings for 60 s keeps its anchors to 1e-7 m and its axis to 1e-6 rad",
    "[R56][long]")
{
  for (const std::string solver : {"direct", "soft_steps"})
  {
    GameWorld world = world_of(solver, {box_body("door", {0.5, 1, 0.02}, {0.5, 0, 0}, 20)});
    world = with_joint(world, hinge_at(world, 0, 1, {0, 0, 0}, {1, 0, 1}));
    double apart = 0, tilt = 0;
    for (int i = 0; i < 3600; ++i)
    {
      world.step();
      const FramePose pose = pose_in<HingeJoint>(world);
      apart = std::max(apart, pose.apart.norm());
      tilt = std::max(tilt, pose.a.col(0).cross(pose.b.col(0)).norm());
    }
    CAPTURE(solver);
    CHECK(apart <= (solver == "direct" ? 1e-7 : 1e-4));
    CHECK(tilt <= (solver == "direct" ? 1e-6 : 3e-4));
  }
}
// [hinge_axis]

// [hinge_motor]
TEST_CASE("a motor holds a beam up to its weight's torque, m g l / 2", "[R57]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double part : {0.99, 1.01})
    {
      GameWorld world = beam(solver, {.motor_force = part * 2 * g * 0.5});
      step(world, 120);
      const double angle = joint_of<HingeJoint>(world).angle;
      CAPTURE(solver, part);
      CHECK((part < 1 ? angle < -0.1 : std::abs(angle) <= 1e-3));
    }
  }
}
// [hinge_motor]

// [hinge_spring]
TEST_CASE(
    "a spring bears a beam where its torque is the weight's, and swings it by its inertia",
    "[R57][long]")
{
  GameWorld world = beam("direct", {.stiffness = 100, .damping = 20});
  step(world, 600);
  const double angle = joint_of<HingeJoint>(world).angle;
  CHECK(100 * angle == Catch::Approx(-2 * g * 0.5 * std::cos(angle)).epsilon(1e-6));

  for (const std::string solver : {"direct", "soft_steps"})
  {
    GameWorld free = world_of(solver, {box_body("beam", {0.5, 0.05, 0.05}, {0.5, 0, 0}, 2)}, 0);
    HingeJoint hinge = hinge_at(free, 0, 1, {0, 0, 0}, {0, 0, 1});
    hinge.drive = {.stiffness = 20, .rest = 0.1};
    free = with_joint(free, hinge);
    const double inertia = 2.0 / 12 * (1 + 0.01) + 2 * 0.25;
    const double period = 2 * pi * std::sqrt(inertia / 20);
    std::vector<double> crossings;
    double before = -0.1;
    for (int i = 1; i <= 1200; ++i)
    {
      free.step();
      const double now = joint_of<HingeJoint>(free).angle - 0.1;
      if (before < 0 && now >= 0)
      {
        crossings.push_back((i - now / (now - before)) / 60);
      }
      before = now;
    }
    REQUIRE(crossings.size() > 5);
    const double swings = static_cast<double>(crossings.size() - 1);
    CAPTURE(solver);
    CHECK((crossings.back() - crossings.front()) / swings == Catch::Approx(period).epsilon(1e-3));
  }
}
// [hinge_spring]

TEST_CASE("a motor turns a wheel ten times round, and the angle counts all turns", "[R56]")
{
  GameWorld world = world_of("direct", {box_body("wheel", {0.3, 0.3, 0.1}, {0, 0, 0}, 5)}, 0);
  HingeJoint hinge = hinge_at(world, 0, 1, {0, 0, 0}, {0, 0, 1});
  hinge.drive = {.upper = 20 * pi, .motor_speed = 30, .motor_force = 100};
  world = with_joint(world, hinge);
  step(world, 60);
  CHECK(world.body(1).motion.angular_velocity.z() == Catch::Approx(30).epsilon(1e-6));
  step(world, 90);
  CHECK(joint_of<HingeJoint>(world).angle == Catch::Approx(20 * pi).epsilon(1e-9)); // at the limit
  CHECK(std::abs(world.body(1).motion.angular_velocity.z()) <= 1e-4);
}

// [slider_motor]
TEST_CASE(
    "a slider's motor lifts its load with m g and 1 %, and lets it down with 1 % less", "[R57]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double part : {0.99, 1.01})
    {
      GameWorld world = world_of(solver, {cube_body("load", {0.3, 1, 0.2}, 50)});
      SliderJoint slider = slider_at(world, 0, 1, {0, 0, 0}, {0, 1, 0});
      slider.drive = {.motor_speed = 1, .motor_force = part * 50 * g};
      world = with_joint(world, slider);
      step(world, 60);
      const double position =
          slider_position(joint_of<SliderJoint>(world), world.body(0), world.body(1));
      CAPTURE(solver, part);
      CHECK(position == Catch::Approx((part - 1) * g / 2).epsilon(0.05)); // a t² / 2
      CHECK(pose_in<SliderJoint>(world).turned.vec().norm() <= 1e-3);
    }
  }
}
// [slider_motor]

// [weld_beam]
/// A beam of ten parts of 50 cm and 1 kg, welded to a wall and to each other, after five seconds.
GameWorld welded_beam_after(const std::string& solver)
{
  std::vector<SceneBody> parts;
  for (int i = 0; i < 10; ++i)
  {
    parts.push_back(box_body("part", {0.25, 0.1, 0.1}, {0.25 + 0.5 * i, 0, 0}));
  }
  GameWorld world = world_of(solver, parts);
  WeldJoints welds;
  for (std::size_t i = 0; i < 10; ++i)
  {
    welds.add(weld_at(world, i, i + 1, {0.5 * static_cast<double>(i), 0, 0}));
  }
  world.add(welds);
  step(world, 300);
  return world;
}

TEST_CASE(
    "a beam of ten welds droops by less than 1 um and bears its torque, 245.25 N m; under soft "
    "steps it hangs down by 2 m",
    "[R55][long]")
{
  GameWorld world = welded_beam_after("direct");
  CHECK(std::abs(world.body(10).motion.center.y()) <= 1e-6);
  const JointImpulses& first = world.constraints<WeldJoints>(0).impulses(0);
  CHECK(60 * first[1] == Catch::Approx(10 * g).epsilon(1e-6));
  CHECK(60 * first[5] == Catch::Approx(10 * g * 2.5).epsilon(1e-6));
  CHECK(welded_beam_after("soft_steps").body(10).motion.center.y() < -2);
}
// [weld_beam]

// [rope]
TEST_CASE("a rope let go level pulls with 3 m g below, and is slack before it is taut", "[R58]")
{
  for (const std::string solver : {"direct", "soft_steps"})
  {
    GameWorld world = world_of(solver, {ball_body("lamp", 0.1, {1, 0, 0}, 2)});
    world = with_joint(world, rope_between(world, 0, 1, {0, 0, 0}, {1, 0, 0}, 1));
    double most = 0;
    for (int i = 0; i < 60; ++i)
    {
      world.step();
      most = std::max(most, 60 * world.constraints<DistanceJoints>(0).impulses(0)[0]);
    }
    CAPTURE(solver);
    CHECK(most == Catch::Approx(3 * 2 * g).epsilon(solver == "direct" ? 2e-3 : 0.02));

    GameWorld slack = world_of(solver, {ball_body("lamp", 0.1, {0, -0.5, 0}, 2)});
    slack = with_joint(slack, rope_between(slack, 0, 1, {0, 0, 0}, {0, -0.5, 0}, 1));
    step(slack, 18); // it falls by .441 m
    CHECK(slack.body(1).motion.velocity.y() == Catch::Approx(-18 * g / 60).epsilon(1e-9));
    step(slack, 60);
    CHECK(slack.body(1).motion.center.y() == Catch::Approx(-1).margin(1e-4));
  }
}

TEST_CASE("a rod keeps its length both ways, and bounds keep a distance between two", "[R58]")
{
  GameWorld world = world_of("direct", {ball_body("bob", 0.1, {0.1, 1, 0}, 2)});
  world = with_joint(world, rod_between(world, 0, 1, {0, 0, 0}, {0.1, 1, 0}));
  double least = 2, most = 0;
  for (int i = 0; i < 600; ++i)
  {
    world.step();
    least = std::min(least, world.body(1).motion.center.norm());
    most = std::max(most, world.body(1).motion.center.norm());
  }
  CHECK(most - least <= 1e-6);

  GameWorld held = world_of("direct", {ball_body("bob", 0.1, {0, 1, 0}, 2)});
  DistanceJoint bounds = rod_between(held, 0, 1, {0, 0, 0}, {0, 1, 0});
  bounds.least = 0.5;
  bounds.most = 2;
  held = with_joint(held, bounds);
  step(held, 120);
  CHECK(held.body(1).motion.center.y() == Catch::Approx(0.5).margin(1e-6));
}

TEST_CASE(
    "a rope whose ends are in one place holds once it is taut; one without length is refused",
    "[R58]")
{
  for (const std::string solver : {"direct", "soft_steps", "position_based"})
  {
    GameWorld world = world_of(solver, {ball_body("bob", 0.1, {0, 0, 0}, 2)});
    DistanceJoint rope = rope_between(world, 0, 1, {0, 0, 0}, {0, 0, 0}, 0.3);
    rope.collides = false;
    world = with_joint(world, rope);
    step(world, 120);
    CAPTURE(solver);
    CHECK(world.body(1).motion.center.y() == Catch::Approx(-0.3).epsilon(1e-3));
  }
  DistanceJoints none;
  CHECK_THROWS_WITH(
      none.add({0, 1, {0, 0, 0}, {0, 0, 0}, 0, 0}),
      "joint: most is zero; a ball joint holds two points together");
}
// [rope]

// [cone]
TEST_CASE("an arm rests on its cone, 30° below the axis, and its twist at its bounds", "[R59]")
{
  GameWorld world = world_of("direct", {box_body("arm", {0.5, 0.05, 0.05}, {0.5, 0, 0}, 2)});
  ConeTwistJoint joint = cone_twist_at(world, 0, 1, {0, 0, 0}, {1, 0, 0});
  joint.cone = pi / 6;
  joint.twist = {.lower = -0.2, .upper = 0.3, .motor_speed = 1, .motor_force = 1};
  world = with_joint(world, joint);
  step(world, 300);
  CHECK(world.body(1).motion.center.y() == Catch::Approx(-0.25).epsilon(1e-6));
  CHECK(joint_of<ConeTwistJoint>(world).angle == Catch::Approx(0.3).epsilon(1e-6));
}
// [cone]

// [wheel]
TEST_CASE(
    "a car of 400 kg on four springs of 10 kN/m sags by m g / 4 k, at any step", "[R60][long]")
{
  for (const double rate : {60.0, 240.0})
  {
    Scene scene{
        .step = 1 / rate, .bodies = {ground(), box_body("car", {1, 0.2, 0.6}, {0, 0.6, 0}, 400)}};
    for (int i = 0; i < 4; ++i)
    {
      const double x = i < 2 ? 0.8 : -0.8, z = i % 2 == 0 ? 0.7 : -0.7;
      scene.bodies.push_back(ball_body("wheel", 0.3, {x, 0.3, z}, 10));
    }
    GameWorld world(scene, solver_named("direct"));
    WheelJoints wheels;
    for (std::size_t i = 2; i < 6; ++i)
    {
      WheelJoint wheel = wheel_at(world, 1, i, {0, 0, 1}, {0, 1, 0});
      wheel.suspension = {.stiffness = 10'000, .damping = 1'000};
      wheels.add(wheel);
    }
    world.add(wheels);
    step(world, static_cast<int>(10 * rate));
    CHECK(0.6 - world.body(1).motion.center.y() == Catch::Approx(400 * g / 40'000).epsilon(1e-4));
  }
}

TEST_CASE("a wheel is turned by its motor, and steered about its suspension", "[R60]")
{
  GameWorld world = world_of("direct", {box_body("wheel", {0.3, 0.3, 0.1}, {0, -0.5, 0}, 10)}, 0);
  WheelJoint wheel = wheel_at(world, 0, 1, {0, 0, 1}, {0, 1, 0});
  wheel.suspension = {.lower = -0.1, .upper = 0.1, .stiffness = 10'000, .damping = 500};
  wheel.spin = {.motor_speed = -20, .motor_force = 50};
  wheel.steering = 0.4;
  world = with_joint(world, wheel);
  step(world, 120);
  const Vector3<double> axle(std::sin(0.4), 0, std::cos(0.4));
  CHECK((world.body(1).axes.col(2) - axle).norm() <= 1e-6);
  CHECK(world.body(1).motion.angular_velocity.dot(axle) == Catch::Approx(-20).epsilon(1e-6));
}
// [wheel]

// [mouse]
TEST_CASE("a mouse joint lifts what weighs less than its force, and no more", "[R61][long]")
{
  for (const std::string solver : {"direct", "soft_steps", "sequential_impulses"})
  {
    for (const double part : {0.99, 1.01})
    {
      GameWorld world = world_of(solver, {box_body("crate", {0.2, 0.2, 0.2}, {1, 0, 0}, 10)});
      MouseJoint mouse = mouse_at(world, 0, 1, {1, 0.2, 0});
      mouse.target = {1, 2, 0};
      mouse.max_force = part * 10 * g;
      world = with_joint(world, mouse);
      step(world, 600);
      CAPTURE(solver, part);
      const double height = world.body(1).motion.center.y();
      CHECK((part < 1 ? height < 0 : std::abs(height - 1.8) <= 0.02));
    }
  }
}
// [mouse]

// [breaking]
TEST_CASE(
    "a sign falls where a chain's strength is 1 % below its weight, not where it is 1 % above",
    "[R62]")
{
  for (const std::string& solver : solver_names())
  {
    for (const double part : {0.99, 1.01})
    {
      GameWorld world = world_of(solver, {box_body("sign", {0.5, 0.3, 0.05}, {0, -0.5, 0}, 4)});
      BallJoints chains;
      chains.add(ball_joint_at(world, 0, 1, {0, -0.2, 0}));
      chains.set_strength(0, part * 4 * g);
      world.add(chains);
      step(world, 30);
      BallJoints& after = world.constraints<BallJoints>(0);
      CAPTURE(solver, part);
      CHECK(
          broken_joints(after) ==
          (part < 1 ? std::vector<std::size_t>{0} : std::vector<std::size_t>{}));
      CHECK((world.body(1).motion.center.y() < -0.6) == (part < 1));
      if (part > 1)
      {
        CHECK(after.force(0).y() == Catch::Approx(4 * g).epsilon(1e-3));
      }
    }
  }
  BallJoints chains;
  CHECK_THROWS_AS(chains.set_strength(0, -1), std::invalid_argument);
}

TEST_CASE("a bridge breaks where it is pulled most, and the set says where", "[R62]")
{
  GameWorld world = world_of(
      "direct", {ball_body("first", 0.1, {0, -0.5, 0}, 1), ball_body("second", 0.1, {0, -1, 0}, 1),
                 ball_body("third", 0.1, {0, -1.5, 0}, 1)});
  BallJoints joints;
  for (std::size_t i = 0; i < 3; ++i)
  {
    joints.add(ball_joint_at(world, i, i + 1, {0, -0.5 * static_cast<double>(i), 0}));
    joints.set_strength(i, 2.5 * g); // the first bears 3 g
  }
  world.add(joints);
  step(world, 30);
  CHECK(broken_joints(world.constraints<BallJoints>(0)) == std::vector<std::size_t>{0});
}
// [breaking]

namespace
{

/// Two boxes in space that tumble on a joint.
template <class Kind, class Make>
GameWorld tumbling(const std::string& solver, const Make& make)
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {
      box_body("one", {0.1, 0.2, 0.3}, {0, 0, 0}, 1),
      box_body("other", {0.1, 0.5, 0.1}, {1, 0, 0}, 3)};
  scene.bodies[0].angular_velocity = {0, 2, 1};
  scene.bodies[1].velocity = {0, 1, 0};
  scene.bodies[1].angular_velocity = {3, 0, 1};
  GameWorld world(scene, solver_named(solver));
  Kind joint = make(world);
  joint.collides = false;
  return with_joint(world, joint);
}

const JointDrive driven{
    .lower = -0.5, .upper = 0.5, .motor_speed = 2, .motor_force = 5, .stiffness = 10, .damping = 1};

/// Calls `call(name, world)` with two boxes on each kind of joint, with limits and motors.
template <class Call>
void each_tumbling(const std::string& solver, const Call& call)
{
  const Vector3<double> point(0.5, 0.1, 0), axis(1, 2, 0);
  call(
      "weld",
      tumbling<WeldJoint>(solver, [&](const GameWorld& w) { return weld_at(w, 0, 1, point); }));
  call(
      "hinge", tumbling<HingeJoint>(
                   solver,
                   [&](const GameWorld& w)
                   {
                     HingeJoint joint = hinge_at(w, 0, 1, point, axis);
                     joint.drive = driven;
                     return joint;
                   }));
  call(
      "slider", tumbling<SliderJoint>(
                    solver,
                    [&](const GameWorld& w)
                    {
                      SliderJoint joint = slider_at(w, 0, 1, point, axis);
                      joint.drive = driven;
                      return joint;
                    }));
  call(
      "cone", tumbling<ConeTwistJoint>(
                  solver,
                  [&](const GameWorld& w)
                  {
                    ConeTwistJoint joint = cone_twist_at(w, 0, 1, point, axis);
                    joint.cone = 0.5;
                    joint.twist = driven;
                    return joint;
                  }));
  call(
      "wheel", tumbling<WheelJoint>(
                   solver,
                   [&](const GameWorld& w)
                   {
                     WheelJoint joint = wheel_at(w, 0, 1, axis, {0, 0, 1});
                     joint.suspension = driven;
                     joint.spin = driven;
                     return joint;
                   }));
  call(
      "rope", tumbling<DistanceJoint>(
                  solver,
                  [&](const GameWorld& w) {
                    return rope_between(w, 0, 1, {0.1, 0, 0}, {0.9, 0, 0}, 0.8);
                  }));
  call(
      "mouse",
      tumbling<MouseJoint>(solver, [&](const GameWorld& w) { return mouse_at(w, 0, 1, point); }));
}

} // namespace

// [joint_momenta]
TEST_CASE(
    "two bodies in space keep their momenta to rounding on every kind of joint", "[R54][long]")
{
  for (const std::string solver : {"direct", "soft_steps"})
  {
    each_tumbling(
        solver,
        [&](const std::string& kind, GameWorld world)
        {
          const Vector3<double> linear = momentum(world.bodies());
          const Vector3<double> angular = angular_momentum(world.bodies());
          step(world, 120);
          CAPTURE(solver, kind);
          CHECK((momentum(world.bodies()) - linear).norm() <= 1e-12 * linear.norm());
          CHECK((angular_momentum(world.bodies()) - angular).norm() <= 1e-12 * angular.norm());
        });
  }
}
// [joint_momenta]

TEST_CASE(
    "every kind of joint, copied with its motors, goes on to the bit under every solver", "[long]")
{
  for (const std::string& solver : solver_names())
  {
    each_tumbling(
        solver,
        [&](const std::string& kind, GameWorld world)
        {
          step(world, 20);
          GameWorld copy = world;
          step(world, 40);
          step(copy, 40);
          CAPTURE(solver, kind);
          CHECK(world.body(1).motion.center.allFinite());
          CHECK(world.body(1).motion.center == copy.body(1).motion.center);
          CHECK(world.body(1).orientation.coeffs() == copy.body(1).orientation.coeffs());
        });
  }
}
