/// \file
/// What a world owes to joints of every kind: islands, sleep, filters, order, refusals; and scenes
/// on which joints might break.

#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/islands/island_view.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "07_constraints/joints/joints.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

using namespace cookbook;

namespace
{

const double pi = std::numbers::pi, g = 9.81;
const double none = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> usual{"direct", "soft_steps"};

void run(GameWorld& world, int steps)
{
  for (int i = 0; i < steps; ++i)
  {
    world.step();
  }
}

/// How every kind of joint is put between two bodies that lie along x, and whether they may touch.
using Join = std::function<void(GameWorld&, BodyId, BodyId, bool)>;

template <class Kind>
void join(GameWorld& world, Kind joint, bool collides)
{
  joint.collides = collides;
  JointSet<Kind> set;
  set.add(joint);
  world.add(set);
}

struct NamedJoin
{
  std::string kind;
  Join call;
};

/// All kinds, at the middle between two bodies, about or along an upright axis.
std::vector<NamedJoin> all_kinds()
{
  const auto middle = [](const GameWorld& w, BodyId a, BodyId b) -> Vector3<double>
  { return (w.body(a).motion.center + w.body(b).motion.center) / 2; };
  const Vector3<double> up(0, 1, 0);
  return {
      {"ball joint", [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       { join(w, ball_joint_at(w, a, b, middle(w, a, b)), touch); }},
      {"weld", [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       { join(w, weld_at(w, a, b, middle(w, a, b)), touch); }},
      {"hinge", [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       { join(w, hinge_at(w, a, b, middle(w, a, b), up), touch); }},
      {"slider",
       [=](GameWorld& w, BodyId a, BodyId b, bool touch) {
         join(w, slider_at(w, a, b, middle(w, a, b), {1, 0, 0}), touch);
       }},
      {"rod", [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       { join(w, rod_between(w, a, b, w.body(a).motion.center, w.body(b).motion.center), touch); }},
      {"cone-twist joint",
       [=](GameWorld& w, BodyId a, BodyId b, bool touch) {
         join(w, cone_twist_at(w, a, b, middle(w, a, b), {1, 0, 0}), touch);
       }},
      {"wheel",
       [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       {
         WheelJoint wheel = wheel_at(w, a, b, {0, 0, 1}, up);
         wheel.suspension = {.stiffness = 1000, .damping = 100};
         join(w, wheel, touch);
       }},
      {"mouse joint", [=](GameWorld& w, BodyId a, BodyId b, bool touch)
       { join(w, mouse_at(w, a, b, w.body(b).motion.center), touch); }}};
}

/// Cubes of 1 m and 1 kg on the ground, at these places along x.
Scene cubes_at(const std::vector<double>& places)
{
  Scene scene{.bodies = {ground()}};
  for (const double x : places)
  {
    scene.bodies.push_back(cube_body("cube", {x, 0.5, 0}));
  }
  return scene;
}

/// Whether two worlds have the same bits.
bool same_bits(const GameWorld& one, const GameWorld& other)
{
  return std::equal(
      one.bodies().begin(), one.bodies().end(), other.bodies().begin(), other.bodies().end(),
      [](const RigidBody& a, const RigidBody& b)
      {
        return a.motion.center == b.motion.center && a.motion.velocity == b.motion.velocity &&
               a.orientation.coeffs() == b.orientation.coeffs();
      });
}

} // namespace

TEST_CASE("by every kind of joint, three bodies are one island, and two such rows are two")
{
  for (const auto& [kind, call] : all_kinds())
  {
    std::vector<std::size_t> sizes;
    const auto count = [&](IslandView, const Island& island, double)
    { sizes.push_back(island.bodies.size()); };
    GameWorld world(cubes_at({0, 2, 4, 20, 22, 24}), count);
    for (const BodyId first : {1U, 2U, 4U, 5U})
    {
      call(world, first, first + 1, true);
    }
    world.step();
    CAPTURE(kind);
    CHECK(sizes == std::vector<std::size_t>{3, 3});
  }
}

TEST_CASE("on every kind of joint two cubes sleep within 2 s, and both wake where one is pushed")
{
  for (const auto& [kind, call] : all_kinds())
  {
    for (const std::string& solver : usual)
    {
      GameWorld world(cubes_at({0, 2}), solver_named(solver), true);
      call(world, 1, 2, false);
      run(world, 120);
      CAPTURE(kind, solver);
      CHECK((world.is_asleep(1) && world.is_asleep(2)));
      world.set_velocity(1, {0, 0, 1}, {0, 0, 0});
      CHECK_FALSE(world.is_asleep(2));
      run(world, 600);
      CHECK((world.is_asleep(1) && world.is_asleep(2)));
    }
  }
}

// [joint_wakes]
TEST_CASE("a motor that is given another speed wakes its bodies, and so does a mouse that moves")
{
  for (const std::string& solver : usual)
  {
    CAPTURE(solver);
    GameWorld world(cubes_at({0, 2}), solver_named(solver), true);
    HingeJoint hinge = hinge_at(world, 1, 2, {1, 0.5, 0}, {0, 1, 0});
    hinge.drive.motor_force = 1000;
    HingeJoints hinges;
    hinges.add(hinge);
    world.add(hinges);
    run(world, 120);
    REQUIRE(world.is_asleep(2));
    hinge.drive.motor_speed = 1;
    world.constraints<HingeJoints>(0).set(0, hinge);
    run(world, 30);
    CHECK_FALSE(world.is_asleep(2));
    CHECK(world.constraints<HingeJoints>(0)[0].angle > 0.1);

    GameWorld dragged(cubes_at({0}), solver_named(solver), true);
    MouseJoint mouse = mouse_at(dragged, 0, 1, {0, 0.5, 0});
    MouseJoints mice;
    mice.add(mouse);
    dragged.add(mice);
    run(dragged, 120);
    REQUIRE(dragged.is_asleep(1));
    mouse.target.y() += 1;
    dragged.constraints<MouseJoints>(0).set(0, mouse);
    run(dragged, 60);
    CHECK(dragged.body(1).motion.center.y() > 1);
  }
}

TEST_CASE("a sign that sleeps falls where its joint's strength is taken, whenever that is")
{
  for (const std::string& solver : usual)
  {
    for (int frame = 25; frame < 40; ++frame) // it falls asleep in between
    {
      Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 3, 0}, 0)}};
      scene.bodies.push_back(box_body("sign", {0.5, 0.3, 0.05}, {0, 2.5, 0}, 4));
      GameWorld world(scene, solver_named(solver), true);
      BallJoints joints;
      joints.add(ball_joint_at(world, 0, 1, {0, 2.8, 0}));
      world.add(joints);
      run(world, frame);
      world.constraints<BallJoints>(0).set_strength(0, 0);
      run(world, 40);
      CAPTURE(solver, frame);
      CHECK(world.constraints<BallJoints>(0).is_broken(0));
      CHECK(world.body(1).motion.center.y() < 2);
      world.constraints<BallJoints>(0).set_strength(0, 1e9);
      world.constraints<BallJoints>(0).mend(0); // it comes back
      run(world, 600);
      CHECK(world.body(1).motion.center.y() > 2);
    }
  }
}
// [joint_wakes]

TEST_CASE("on every kind of joint two overlapping cubes touch only where the joint says so")
{
  for (const auto& [kind, call] : all_kinds())
  {
    for (const bool touch : {false, true})
    {
      Scene scene = cubes_at({0, 0.8});
      scene.gravity.setZero();
      scene.bodies.erase(scene.bodies.begin());
      GameWorld world(scene, solver_named("soft_steps"));
      call(world, 0, 1, touch);
      world.step();
      CAPTURE(kind, touch);
      CHECK(world.contacts().empty() != touch);
    }
  }
}

TEST_CASE(
    "two runs of a swinging chain have equal bits; by joints added from below, direct has the same "
    "to 1e-9 m, soft steps to 1 cm")
{
  const auto swung = [](const std::string& solver, bool from_below)
  {
    Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, {0, 9, 0}, 0)}};
    for (int i = 0; i < 5; ++i)
    {
      scene.bodies.push_back(box_body("link", {0.25, 0.05, 0.05}, {0.25 + 0.5 * i, 9, 0}));
    }
    GameWorld world(scene, solver_named(solver));
    BallJoints joints;
    for (int k = 0; k < 5; ++k)
    {
      const int i = from_below ? 4 - k : k;
      const auto upper = static_cast<BodyId>(i);
      joints.add(ball_joint_at(world, upper, upper + 1, {0.5 * i, 9, 0}));
    }
    world.add(joints);
    run(world, 40);
    return world;
  };
  for (const std::string& solver : solver_names())
  {
    CAPTURE(solver);
    const GameWorld down = swung(solver, false), up = swung(solver, true);
    CHECK(same_bits(down, swung(solver, false)));
    const double off = (down.body(5).motion.center - up.body(5).motion.center).norm();
    CAPTURE(off);
    CHECK((solver != "direct" || off <= 1e-9));
    CHECK((solver != "soft_steps" || off <= 0.01));
  }
}

TEST_CASE("a joint of a body with itself, or of one that is not there, is refused, nothing lost")
{
  for (const auto& [kind, call] : all_kinds())
  {
    GameWorld world(cubes_at({0, 2}), solver_named("direct"));
    call(world, 1, 2, false);
    GameWorld before = world;
    CAPTURE(kind);
    CHECK_THROWS_AS(call(world, 2, 2, true), std::invalid_argument);
    CHECK_THROWS_AS(call(world, 2, 7, true), std::out_of_range);
    run(world, 30);
    run(before, 30);
    CHECK(same_bits(world, before));
  }
  GameWorld world(cubes_at({0, 2}), solver_named("direct"));
  BallJoints joints;
  joints.add({1, 1, {0, 0, 0}, {0, 0, 0}});
  CHECK_THROWS_WITH(world.add(joints), "ball joints: number 0 joins body 1 with itself");
}

TEST_CASE("a joint that is set to a body that is not there stops a step before anything moves")
{
  GameWorld world(cubes_at({0, 2}), solver_named("soft_steps"));
  BallJoints joints;
  joints.add(ball_joint_at(world, 1, 2, {1, 0.5, 0}));
  world.add(joints);
  GameWorld before = world;
  const BallJoint right = joints[0];
  world.constraints<BallJoints>(0).set(0, {1, 9, {0, 0, 0}, {0, 0, 0}});
  CHECK_THROWS_AS(world.step(), std::out_of_range);
  world.constraints<BallJoints>(0).set(0, right);
  run(world, 30);
  run(before, 30);
  CHECK(same_bits(world, before));
}

TEST_CASE("NaN, reversed limits and negative frequencies are refused by member and value")
{
  const JointFrame odd{{none, 0, 0}};
  const JointFrame scaled{{0, 0, 0}, {2, 0, 0, 0}};
  CHECK_THROWS_WITH(
      check_joint(BallJoint{0, 1, {none, 0, 0}, {0, 0, 0}}), "joint: anchor_a is not finite");
  CHECK_THROWS_WITH(check_joint(WeldJoint{0, 1, odd, {}}), "joint: frame_a.anchor is not finite");
  CHECK_THROWS_AS(check_joint(WheelJoint{0, 1, scaled, {}}), std::invalid_argument);
  CHECK_THROWS_AS(check_joint(HingeJoint{0, 1, {}, {}, {.lower = none}}), std::invalid_argument);
  CHECK_THROWS_AS(check_joint(SliderJoint{0, 1, {}, {}, {.rest = none}}), std::invalid_argument);
  CHECK_THROWS_WITH(
      check_joint(SliderJoint{0, 1, {}, {}, {.stiffness = -1}}),
      "joint: drive.stiffness is -1.000000; it must be finite and zero or more");
  CHECK_THROWS_AS(check_joint(ConeTwistJoint{0, 1, {}, {}, none}), std::invalid_argument);
  CHECK_THROWS_AS(
      check_joint(ConeTwistJoint{0, 1, {}, {}, 1, {.lower = 1, .upper = -1}}),
      std::invalid_argument);
  WheelJoint wheel{0, 1, {}, {}};
  wheel.steering = none;
  CHECK_THROWS_AS(check_joint(wheel), std::invalid_argument);
  CHECK_THROWS_AS(
      check_joint(DistanceJoint{0, 1, {0, 0, 0}, {0, 0, 0}, 0, none}), std::invalid_argument);
  MouseJoint mouse{0, 1, {0, 0, 0}, {0, 0, 0}};
  mouse.frequency = -1;
  CHECK_THROWS_AS(check_joint(mouse), std::invalid_argument);
  HingeJoints hinges;
  hinges.add({0, 1, {}, {}});
  CHECK_THROWS_AS(hinges.set(0, {0, 1, {}, {}, {.damping = none}}), std::invalid_argument);
  CHECK(hinges[0].drive.damping == 0); // as it was
  CHECK_THROWS_AS(hinges.set_strength(0, none), std::invalid_argument);
  CHECK_THROWS_AS(hinges.set_strength(1, 5), std::out_of_range);
}

namespace
{

/// A world of bodies without ground, after a post at the origin.
GameWorld posted(const std::string& solver, std::vector<SceneBody> bodies, double gravity = g)
{
  bodies.insert(bodies.begin(), box_body("post", {0.05, 0.05, 0.05}, {0, 0, 0}, 0));
  return GameWorld({.gravity = {0, -gravity, 0}, .bodies = bodies}, solver_named(solver));
}

/// Adds one joint.
template <class Kind>
std::size_t put(GameWorld& world, const Kind& joint)
{
  JointSet<Kind> set;
  set.add(joint);
  return world.add(set);
}

/// How far [m] the anchors of a ball joint, the first of the world's first set, are apart.
double apart(GameWorld& world)
{
  const BallJoint& joint = world.constraints<BallJoints>(0)[0];
  const RigidBody &a = world.body(static_cast<BodyId>(joint.a)),
                  &b = world.body(static_cast<BodyId>(joint.b));
  return anchors_of(a, b, joint.anchor_a, joint.anchor_b).error.norm();
}

} // namespace

TEST_CASE("a hinge at ±π stops there, and one whose axes are opposite at first turns round")
{
  for (const std::string& solver : usual)
  {
    CAPTURE(solver);
    GameWorld bounded = posted(solver, {box_body("arm", {0.5, 0.1, 0.1}, {0, 0, 0}, 2)}, 0);
    HingeJoint hinge = hinge_at(bounded, 0, 1, {0, 0, 0}, {0, 0, 1});
    hinge.drive = {.lower = -pi, .upper = pi, .motor_speed = 3, .motor_force = 50};
    put(bounded, hinge);
    run(bounded, 300);
    CHECK(bounded.constraints<HingeJoints>(0)[0].angle == Catch::Approx(pi).margin(3e-3));
    CHECK(bounded.body(1).motion.angular_velocity.norm() <= 1e-9);

    GameWorld opposite = posted(solver, {box_body("arm", {0.5, 0.1, 0.1}, {0.5, 0, 0}, 2)}, 0);
    put(opposite,
        HingeJoint{
            0, 1, {{0, 0, 0}, axes_about({0, 1, 0})}, {{-0.5, 0, 0}, axes_about({0, -1, 0})}});
    run(opposite, 300);
    const HingeJoint& after = opposite.constraints<HingeJoints>(0)[0];
    const FramePose pose =
        frame_pose(opposite.body(0), opposite.body(1), after.frame_a, after.frame_b);
    CHECK(pose.a.col(0).dot(pose.b.col(0)) == Catch::Approx(1).epsilon(1e-9));
    CHECK(energy(opposite.bodies(), {0, 0, 0}) <= 1e-20);
  }
}

TEST_CASE("a wheel at 1,000 turns a minute stays upright, and its angle counts 100 turns")
{
  for (const std::string& solver : usual)
  {
    GameWorld world = posted(solver, {box_body("wheel", {0.3, 0.3, 0.1}, {0, -0.5, 0}, 10)}, 0);
    WheelJoint wheel = wheel_at(world, 0, 1, {0, 0, 1}, {0, 1, 0});
    wheel.suspension = {.stiffness = 1e4, .damping = 500};
    wheel.spin = {.upper = 200 * pi, .motor_speed = 1000 * 2 * pi / 60, .motor_force = 200};
    put(world, wheel);
    run(world, 300);
    CAPTURE(solver);
    CHECK(world.body(1).motion.angular_velocity.z() == Catch::Approx(1000 * 2 * pi / 60));
    CHECK((world.body(1).axes.col(2) - Vector3<double>(0, 0, 1)).norm() <= 1e-12);
    run(world, 180);
    CHECK(world.constraints<WheelJoints>(0)[0].angle == Catch::Approx(200 * pi).margin(0.05));
  }
}

TEST_CASE("an arm on the rim of a table that turns at 3 rad/s stays within 1 mm of its hinge")
{
  for (const std::string& solver : usual)
  {
    SceneBody table = box_body("table", {1, 0.1, 1}, {0, -1, 0}, 1);
    table.motion = MotionType::kinematic;
    table.angular_velocity = {0, 3, 0};
    GameWorld world = posted(solver, {table, box_body("arm", {0.5, 0.05, 0.05}, {1.5, -1, 0}, 2)});
    put(world, ball_joint_at(world, 1, 2, {1, -1, 0}));
    double most = 0;
    for (int i = 0; i < 300; ++i)
    {
      world.step();
      most = std::max(most, apart(world));
    }
    CAPTURE(solver, most);
    CHECK(most <= 1e-3);
  }
}

TEST_CASE("a chain a million metres from the origin holds, and so does one with 1,000 t over 1 kg")
{
  for (const std::string& solver : usual)
  {
    CAPTURE(solver);
    const Vector3<double> away(1e6, 0, 0);
    Scene scene{.bodies = {box_body("hook", {0.1, 0.1, 0.1}, away, 0)}};
    scene.bodies.push_back(
        box_body("link", {0.05, 0.25, 0.05}, away - Vector3<double>(0, 0.25, 0)));
    scene.bodies[1].velocity = {1, 0, 0};
    GameWorld distant(scene, solver_named(solver));
    put(distant, ball_joint_at(distant, 0, 1, away));
    run(distant, 300);
    CHECK(apart(distant) <= 2e-4);

    GameWorld heavy = posted(
        solver,
        {ball_body("heavy", 0.3, {0, -0.5, 0}, 1e6), ball_body("light", 0.3, {0, -1.5, 0}, 1)});
    put(heavy, ball_joint_at(heavy, 1, 2, {0, -1, 0}));
    put(heavy, ball_joint_at(heavy, 0, 1, {0, 0, 0}));
    heavy.set_velocity(2, {1, 0, 0}, {0, 0, 0});
    run(heavy, 300);
    CHECK(apart(heavy) <= 2e-4);
  }
}

TEST_CASE("joints that are open by 1 m close without a rebound; between fixed bodies nothing moves")
{
  for (const std::string& solver : usual)
  {
    GameWorld world = posted(solver, {ball_body("ball", 0.2, {1, 0, 0}, 2)}, 0);
    put(world, BallJoint{0, 1, {0, 0, 0}, {0, 0, 0}});
    double most = 0;
    for (int i = 0; i < 60; ++i)
    {
      world.step();
      most = std::max(most, energy(world.bodies(), {0, 0, 0}));
    }
    CAPTURE(solver);
    CHECK(most <= 1e-12);
    CHECK(apart(world) <= 1e-9);

    GameWorld still = posted(solver, {box_body("other", {0.1, 0.1, 0.1}, {2, 0, 0}, 0)});
    HingeJoint hinge = hinge_at(still, 0, 1, {0, 0, 0}, {0, 1, 0});
    hinge.drive.motor_force = 5;
    put(still, hinge);
    run(still, 10);
    CHECK(still.body(1).motion.center.x() == 2);
  }
}

TEST_CASE("a scene and its mirror image go the same way to the bit")
{
  const auto end = [](const std::string& solver, double side)
  {
    GameWorld world = posted(
        solver, {box_body("arm", {0.5, 0.05, 0.05}, {0.5 * side, 0, 0}, 2),
                 box_body("hand", {0.5, 0.05, 0.1}, {1.5 * side, 0, 0}, 1)});
    put(world, ball_joint_at(world, 0, 1, {0, 0, 0}));
    put(world, hinge_at(world, 1, 2, {side, 0, 0}, {0, 0, side}));
    world.set_velocity(2, {0, 0, 0.3}, {0, 0, 0});
    run(world, 120);
    const Vector3<double>& center = world.body(2).motion.center;
    return Vector3<double>(side * center.x(), center.y(), center.z());
  };
  for (const std::string& solver : usual)
  {
    CHECK(end(solver, 1) == end(solver, -1));
  }
}

// [contradiction]
TEST_CASE(
    "joints that contradict each other by 20 cm leave a beam at rest; by 2 m soft steps fling it, "
    "direct does not")
{
  const auto held = [](const std::string& solver, double off)
  {
    GameWorld world = posted(
        solver, {box_body("left", {0.1, 0.1, 0.1}, {-0.25 - off, 3, 0}, 0),
                 box_body("right", {0.1, 0.1, 0.1}, {0.25 + off, 3, 0}, 0),
                 box_body("beam", {0.25, 0.05, 0.05}, {0, 3, 0})});
    put(world, BallJoint{1, 3, {0, 0, 0}, {-0.25, 0, 0}});
    put(world, BallJoint{2, 3, {0, 0, 0}, {0.25, 0, 0}});
    run(world, 300);
    Motion<double> motion = world.body(3).motion;
    motion.center.y() -= 3;
    return motion;
  };
  for (const std::string& solver : usual)
  {
    const Motion<double> beam = held(solver, 0.1);
    CAPTURE(solver);
    CHECK(beam.center.norm() <= 0.04);
    CHECK(beam.velocity.norm() <= 0.01);
  }
  CHECK(held("direct", 1).center.norm() <= 1e-6);
  CHECK(held("soft_steps", 1).center.norm() > 1000);
}
// [contradiction]

// [tiny_pendulum]
TEST_CASE(
    "a pendulum of 1 km keeps its energy in 20 s; one of 1 mm, of 1.6 rad a frame, gains six times "
    "its swing under soft steps, none under direct")
{
  const auto gained = [](const std::string& solver, double length)
  {
    const double sine = 0.3, cosine = std::sqrt(1 - sine * sine);
    GameWorld world = posted(
        solver, {ball_body("bob", 0.1 * length, length * Vector3<double>(sine, -cosine, 0))});
    put(world, ball_joint_at(world, 0, 1, {0, 0, 0}));
    const double start = energy(world.bodies(), {0, -g, 0});
    double most = start;
    for (int i = 0; i < 1200; ++i)
    {
      world.step();
      most = std::max(most, energy(world.bodies(), {0, -g, 0}));
    }
    return (most - start) / (g * length * (1 - cosine));
  };
  CHECK(gained("direct", 1000) <= 1e-3);
  CHECK(gained("soft_steps", 1000) <= 1e-3);
  CHECK(gained("direct", 0.001) <= 0);
  CHECK(gained("soft_steps", 0.001) > 3);
}
// [tiny_pendulum]

// [sequential_gains]
TEST_CASE(
    "sequential impulses push energy into chains: by what they correct, where 20 links hang with "
    "1 kg, and by what turning adds, where two fall from level for two minutes",
    "[long]")
{
  const auto burst = [](int links, double load, bool level, int frames, double correction)
  {
    std::vector<SceneBody> bodies;
    const double length = level ? 1 : 0.5;
    for (int i = 0; i < links; ++i)
    {
      const double middle = length * (i + 0.5);
      bodies.push_back(
          level ? box_body("link", {length / 2, 0.05, 0.05}, {middle, 0, 0})
                : box_body("link", {0.05, length / 2, 0.05}, {0, -middle, 0}));
    }
    if (load > 0)
    {
      bodies.push_back(box_body("load", {0.25, 0.25, 0.25}, {0, -0.5 * links - 0.25, 0}, load));
    }
    GameWorld made = posted("soft_steps", bodies);
    GameWorld world(
        made.scene(), one_by_one(
                          [=](IslandView view, const Island& island, double step)
                          {
                            const SequentialSettings how{.correction = correction};
                            sequential_impulses(view, island, step, how);
                          }));
    BallJoints joints;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      const double along = length * static_cast<double>(i);
      joints.add(ball_joint_at(
          world, i, i + 1, level ? Vector3<double>(along, 0, 0) : Vector3<double>(0, -along, 0)));
    }
    world.add(joints);
    for (int i = 0; i < frames; ++i)
    {
      world.step();
      if (energy(world.bodies(), {0, -g, 0}) > 1e4)
      {
        return true;
      }
    }
    return false;
  };
  CHECK(burst(20, 1, false, 300, 0.2));
  CHECK_FALSE(burst(20, 1, false, 300, 0));
  CHECK(burst(2, 0, true, 7200, 0.2));
}
// [sequential_gains]

TEST_CASE(
    "a pair in space keeps its energy to 1 % and a double pendulum gains none in two minutes",
    "[long]")
{
  GameWorld pair(
      {.gravity = {0, 0, 0},
       .bodies =
           {box_body("one", {0.1, 0.2, 0.3}, {0, 0, 0}, 1),
            box_body("other", {0.1, 0.5, 0.1}, {1, 0, 0}, 3)}},
      solver_named("direct"));
  put(pair, ball_joint_at(pair, 0, 1, {0.5, 0.1, 0}));
  pair.set_velocity(0, {1, 0, 0}, {0, 2, 1});
  pair.set_velocity(1, {0, 1, 0}, {3, 0, 1});
  run(pair, 2);
  const double start = energy(pair.bodies(), {0, 0, 0});
  run(pair, 7200);
  CHECK(energy(pair.bodies(), {0, 0, 0}) == Catch::Approx(start).epsilon(0.01));

  GameWorld pendulum = posted(
      "direct", {box_body("upper", {0.5, 0.05, 0.05}, {0.5, 0, 0}),
                 box_body("lower", {0.5, 0.05, 0.05}, {1.5, 0, 0})});
  put(pendulum, hinge_at(pendulum, 0, 1, {0, 0, 0}, {0, 0, 1}));
  put(pendulum, hinge_at(pendulum, 1, 2, {1, 0, 0}, {0, 0, 1}));
  double most = 0;
  for (int i = 0; i < 7200; ++i)
  {
    pendulum.step();
    most = std::max(most, energy(pendulum.bodies(), {0, -g, 0}));
  }
  CHECK(most <= 0.01 * 2 * g); // of the swing's 19.6 J
}
