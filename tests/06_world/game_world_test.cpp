/// \file
/// The world: energy, momentum, bounces, walls, the same bits again, and scenes that make no sense.

#include "06_world/game_world/solver_names.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/world_cases.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/game_world/trial/world_runs.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace cookbook;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A ball of 1 kg and radius 0.5 m, its lowest point 1 m above the ground.
Scene falling_ball(double restitution)
{
  Scene scene;
  scene.bodies.push_back({"ground", PlaneShape{{0, 1, 0}, 0}});
  scene.bodies.push_back({"ball", SphereShape{0.5}, 1});
  scene.bodies.back().position = {0, 1.5, 0};
  scene.bodies.back().restitution = restitution;
  return scene;
}

/// The highest places that the last body reaches between touches of the ground, one a bounce.
std::vector<double> apexes(const std::vector<Frame>& frames)
{
  std::vector<double> tops;
  for (std::size_t i = 1; i + 1 < frames.size(); ++i)
  {
    const double before = frames[i - 1].bodies.back().position.y();
    const double now = frames[i].bodies.back().position.y();
    const double after = frames[i + 1].bodies.back().position.y();
    if (now >= before && now > after)
    {
      tops.push_back(now);
    }
  }
  return tops;
}

bool same_bits(const BodyState& a, const BodyState& b)
{
  return a.position == b.position && a.orientation.coeffs() == b.orientation.coeffs() &&
         a.velocity == b.velocity && a.angular_velocity == b.angular_velocity;
}

} // namespace

// [bounce]
TEST_CASE("a ball with e = 1 keeps its energy to 1e-6 for 20 s", "[case:S16]")
{
  const WorldRun run = run_world(falling_ball(1), {.duration = 20});
  CHECK(std::abs(run.energy_end / run.energy_start - 1) <= 1e-6);
  CHECK(run.energy_most <= run.energy_start * (1 + 1e-12));
}

TEST_CASE("a ball with e = 0.5 comes up to a quarter and a sixteenth of its height", "[case:S15]")
{
  const WorldRun run = run_world(falling_ball(0.5), {.duration = 3, .keeps_frames = true});
  const std::vector<double> tops = apexes(run.frames);
  REQUIRE(tops.size() >= 2);
  // A frame may miss the top by half a step: g (h/2)² / 2.
  const double missed = 9.81 / 8 / 3600;
  CHECK(tops[0] - 0.5 == Catch::Approx(0.25).margin(missed));
  CHECK(tops[1] - 0.5 == Catch::Approx(0.0625).margin(missed));
}

TEST_CASE("a cube with e = 1 that lands flat comes up as fast, and does not turn", "[case:S14]")
{
  Scene scene = falling_ball(1);
  scene.bodies.back().shape = BoxShape{{0.5, 0.5, 0.5}};
  const WorldRun run = run_world(scene, {.duration = 5});
  CHECK(std::abs(run.energy_end / run.energy_start - 1) <= 1e-6);
  CHECK(run.frames.back().bodies.back().angular_velocity.norm() <= 1e-6);
}
// [bounce]

// [rest]
TEST_CASE("heaps rest within 20 s: nothing moves at 0.05 mm/s, or turns as fast", "[long]")
{
  for (const char* const solver : {"soft_steps", "wide_steps"})
  {
    for (const int boxes : inputs<std::vector<int>>({60, 80, 120, 160, 200}, {80}))
    {
      GameWorld world(named_scene("pile_" + std::to_string(boxes)), solver_named(solver, 4));
      for (int frame = 0; frame < 20 * 60; ++frame)
      {
        world.step();
      }
      double fastest = 0;
      for (const RigidBody& body : world.bodies())
      {
        const double turning = body.motion.angular_velocity.norm(); // boxes reach about a metre
        fastest = std::max({fastest, body.motion.velocity.norm(), turning});
      }
      INFO(solver << ", " << boxes);
      CHECK(fastest < 5e-5);
    }
  }
}
// [rest]

// [null_body]
TEST_CASE("towers, slopes, dominoes and heaps never gain energy", "[R4][long]")
{
  for (const char* const scene : {"tower", "incline", "rolling", "domino_8", "pile_12", "plates"})
  {
    CAPTURE(scene);
    const WorldRun run = run_world(named_scene(scene), {.duration = 3});
    CHECK(run.energy_most <= run.energy_start * (1 + 1e-9));
  }
}

TEST_CASE("a ball and a cube that nothing touches keep their spin, to the bit", "[R24]")
{
  const Vector3<double> spin(7, -80, 3);
  Scene scene;
  for (const double speed : {0.0, 1.0, 1e3})
  {
    const double across = 5 * static_cast<double>(scene.bodies.size());
    SceneBody sphere{{}, SphereShape{0.3}}, cube{{}, BoxShape{{0.3, 0.3, 0.3}}};
    for (SceneBody* one : {&sphere, &cube})
    {
      one->mass = 2;
      one->position = {across, one == &sphere ? 0.0 : 3.0, 0};
      one->velocity = {0, 0, speed};
      one->angular_velocity = spin;
      scene.bodies.push_back(*one);
    }
  }
  GameWorld world(scene, solver_named("soft_steps"));
  for (int step = 0; step < 1000; ++step)
  {
    world.step();
  }
  for (const RigidBody& body : world.bodies())
  {
    CHECK(body.motion.angular_velocity == spin);
    CHECK(std::abs(body.orientation.norm() - 1) < 1e-15);
  }
}

TEST_CASE("two free boxes that collide keep their momentum to rounding", "[R3]")
{
  Scene scene;
  scene.gravity.setZero();
  for (const double side : {-1.0, 1.0})
  {
    SceneBody box{side < 0 ? "left" : "right", BoxShape{{0.5, 0.3, 0.4}}, 2 + side};
    box.position = {1.2 * side, 0.1 * side, 0};
    box.velocity = {-2 * side, 0.3, 0.1 * side};
    box.restitution = 0.4;
    scene.bodies.push_back(box);
  }
  const GameWorld start(scene, solver_named("direct"));
  const Vector3<double> before = momentum(start.bodies());
  const WorldRun run = run_world(scene, {.duration = 2});
  CHECK(run.frames.back().bodies[0].velocity != scene.bodies[0].velocity);
  CHECK((run.momentum - before).norm() <= 1e-12);
}
// [null_body]

// [walls]
TEST_CASE(
    "a ball of 5 cm never passes a wall of 2 cm, at 1 to 1,000 m/s, and comes back", "[case:J1]")
{
  for (const char* const scene : {"thin_wall_1", "thin_wall_10", "thin_wall_100", "thin_wall_1000"})
  {
    CAPTURE(scene);
    const Scene at_wall = named_scene(scene);
    const double speed = at_wall.bodies[1].velocity.x();
    const std::vector<BodyState> end = run_world(at_wall).frames.back().bodies;
    CHECK(end[1].position.x() < 0);
    CHECK(end[1].velocity.x() == Catch::Approx(-speed).epsilon(1e-12));
    // The other ball passes 3 cm beside the edge of the wall.
    CHECK(end[2].position.x() > 1);
    CHECK(end[2].velocity == Vector3<double>(speed, 0, 0));
  }
}
// [walls]

// [same]
TEST_CASE(
    "a run gives the same bits twice, and a body far away changes none of them", "[case:S20][long]")
{
  for (const char* const name : {"domino_6", "pile_10", "tower"})
  {
    CAPTURE(name);
    const Scene scene = named_scene(name);
    Scene with_other = scene;
    with_other.bodies.push_back({"other", BoxShape{{1, 1, 1}}, 3});
    with_other.bodies.back().position = {500, 2, 0};
    const Frame once = run_world(scene, {.duration = 3}).frames.back();
    const Frame again = run_world(scene, {.duration = 3}).frames.back();
    const Frame other = run_world(with_other, {.duration = 3}).frames.back();
    for (std::size_t i = 0; i < once.bodies.size(); ++i)
    {
      CHECK(same_bits(once.bodies[i], again.bodies[i]));
      CHECK(same_bits(once.bodies[i], other.bodies[i]));
    }
  }
}

TEST_CASE(
    "a tower of five stands in the same place in whatever order it is listed", "[case:S19][long]")
{
  const Scene scene = named_scene("tower_5");
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round)
  {
    Scene shuffled = scene;
    for (std::size_t left = shuffled.bodies.size(); left > 1; --left)
    {
      std::swap(shuffled.bodies[left - 1], shuffled.bodies[random() % left]);
    }
    const WorldRun run = run_world(shuffled, {.duration = 2});
    CHECK(std::hypot(run.sink, run.drift) < 0.01);
  }
}
// [same]

// [bad]
TEST_CASE(
    "a scene that makes no sense is answered with the body, the member and the value", "[case:L3]")
{
  const auto reason = [](const SceneBody& body) -> std::string
  {
    Scene scene;
    scene.bodies.push_back(body);
    try
    {
      run_world(scene, {.duration = 0});
    }
    catch (const InvalidScene& wrong)
    {
      return wrong.what();
    }
    return "none";
  };
  SceneBody crate{"crate", BoxShape{{1, 1, 1}}, 1};
  CHECK(reason(crate) == "none");
  crate.mass = not_a_number;
  CHECK(reason(crate) == "crate: mass must be finite, got nan");
  crate.mass = -2;
  CHECK(reason(crate) == "crate: mass must be zero or more, got -2");
  crate.mass = 1;
  crate.shape = BoxShape{{1, 0, 1}};
  CHECK(reason(crate) == "crate: half_extents.y must be greater than zero, got 0");
  crate.shape = SphereShape{-1};
  CHECK(reason(crate) == "crate: radius must be greater than zero, got -1");
  crate = {"crate", BoxShape{Vector3<double>::Constant(1e-80)}, 1e-200};
  CHECK(reason(crate) == "crate: moments.x must be greater than zero, got 0");
  crate.mass = 1;
  crate.shape = PlaneShape{{0, 1, 0}, 0};
  CHECK(reason(crate) == "crate: mass must be 0 for a plane, got 1");
  crate = {"crate", BoxShape{{1, 1, 1}}, 1};
  crate.position.z() = infinity;
  CHECK(reason(crate) == "crate: position.z must be finite, got inf");
  crate = {"crate", BoxShape{{1, 1, 1}}, 0};
  crate.velocity.x() = 3;
  CHECK(reason(crate) == "crate: velocity must be zero, for mass 0 means fixed, got length 3");
  crate.velocity.x() = 0;
  crate.angular_velocity.y() = 2;
  CHECK(
      reason(crate) ==
      "crate: angular_velocity must be zero, for mass 0 means fixed, got length 2");
  crate.motion = MotionType::kinematic;
  CHECK(reason(crate) == "none");
  crate.motion = MotionType::fixed;
  CHECK(
      reason(crate) == "crate: angular_velocity must be zero, for the body is fixed, got length 2");
  crate = {"crate", PlaneShape{{0, 1, 0}, 0}, 0, MotionType::kinematic};
  CHECK(reason(crate) == "crate: motion must be fixed for a plane, got kinematic");
  crate = {"", BoxShape{{1, 1, 1}}, -1};
  CHECK(reason(crate) == "body 0: mass must be zero or more, got -1");
}

TEST_CASE("what has a range is refused below it, above it, and where it is no number", "[case:L3]")
{
  const auto is_refused = [](const auto& change)
  {
    Scene scene = named_scene("tower_1");
    change(scene, scene.bodies[1]);
    try
    {
      GameWorld(scene, solver_named("direct"));
    }
    catch (const InvalidScene&)
    {
      return true;
    }
    return false;
  };
  using Member = double SceneBody::*;
  struct Range
  {
    Member member;
    double least, most;
  };
  for (const Range& range : std::vector<Range>{
           {&SceneBody::friction, 0, 1e6},
           {&SceneBody::restitution, 0, 1},
           {&SceneBody::damping, 0, 1e6},
           {&SceneBody::angular_damping, 0, 1e6}})
  {
    const auto refuses = [&](double value)
    { return is_refused([&](Scene&, SceneBody& body) { body.*range.member = value; }); };
    CHECK((!refuses(range.least) && !refuses(range.most)));
    CHECK((refuses(std::nextafter(range.least, -1)) && refuses(1.001 * range.most)));
    CHECK((refuses(not_a_number) && refuses(infinity)));
  }
  CHECK(is_refused([](Scene& scene, SceneBody&) { scene.step = 0; }));
  CHECK(is_refused([](Scene& scene, SceneBody&) { scene.duration = -1; }));
  CHECK(is_refused([](Scene& scene, SceneBody&) { scene.gravity.x() = not_a_number; }));
  CHECK(is_refused([](Scene&, SceneBody& body) { body.velocity.x() = infinity; }));
  CHECK(is_refused([](Scene&, SceneBody& body) { body.angular_velocity.x() = infinity; }));
  CHECK(is_refused([](Scene&, SceneBody& body) { body.orientation.coeffs() *= 2; }));
  CHECK(is_refused([](Scene&, SceneBody& body) { body.orientation.coeffs() /= 2; }));
  CHECK(!is_refused([](Scene&, SceneBody& body) { body.orientation.coeffs() *= 1.9; }));
}

TEST_CASE("bodies that ignore themselves, or others that are not there, are refused", "[case:L3]")
{
  for (const auto& wrong : {std::pair(1, 1), std::pair(-1, 0), std::pair(0, 3)})
  {
    Scene scene = named_scene("tower_2");
    scene.ignored = {{0, 1}, wrong};
    CAPTURE(wrong.first, wrong.second);
    CHECK_THROWS_AS(GameWorld(scene, solver_named("direct")), InvalidScene);
  }
}

TEST_CASE("three cubes let fall by a tenth of a millimetre stand if they are of 5 mm, not of 2 mm")
{
  const auto height = [](double edge)
  {
    Scene scene;
    scene.bodies = {ground()};
    for (int i = 0; i < 3; ++i)
    {
      const Vector3<double> place(0, edge * (i + 0.5) + 1e-4 * (i + 1), 0);
      scene.bodies.push_back(
          box_body("cube", Vector3<double>::Constant(edge / 2), place, 1000 * std::pow(edge, 3)));
    }
    GameWorld world(scene, solver_named("direct"));
    while (world.time() < 10)
    {
      world.step();
    }
    return world.bodies()[3].motion.center.y() / edge;
  };
  CHECK(height(0.005) == Catch::Approx(2.5).margin(0.01));
  CHECK(height(0.002) < 1);
}

TEST_CASE("a force that is not finite is refused, and nothing else moves differently", "[case:L3]")
{
  GameWorld pushed(named_scene("pile_10"), solver_named("direct"));
  GameWorld left_alone(named_scene("pile_10"), solver_named("direct"));
  for (int i = 0; i < 60; ++i)
  {
    CHECK_THROWS_AS(apply_force(pushed, 3, {not_a_number, 0, 0}), std::invalid_argument);
    pushed.step();
    left_alone.step();
  }
  for (std::size_t i = 0; i < pushed.bodies().size(); ++i)
  {
    CHECK(pushed.bodies()[i].motion.center == left_alone.bodies()[i].motion.center);
  }
}

TEST_CASE("a force of 1e308 N leaves all numbers finite", "[case:L3]")
{
  GameWorld world(named_scene("pile_10"), solver_named("direct"));
  for (int i = 0; i < 30; ++i)
  {
    apply_force(world, 3, {1e308, -1e308, 0});
    world.step();
  }
  for (const RigidBody& body : world.bodies())
  {
    CHECK(is_finite(body));
  }
}

TEST_CASE("a body that flies off beyond all numbers is kept where it was last, and fixed")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"));
  world.set_velocity(1, {1e308, 1e308, 1e308}, {1e308, 1e308, 1e308});
  for (int i = 0; i < 150; ++i)
  {
    world.step();
  }
  CHECK(is_fixed(world.bodies()[1]));
  CHECK(is_finite(world.bodies()[1]));
  CHECK(world.bodies()[1].motion.velocity == Vector3<double>(0, 0, 0));
  CHECK(world.bodies()[1].motion.angular_velocity == Vector3<double>(0, 0, 0));
  CHECK(world.bodies()[2].motion.center.y() == Catch::Approx(0.5).margin(1e-6)); // fell down
}

TEST_CASE("ten thousand bodies in one place are refused, with a sentence", "[case:L3]")
{
  Scene scene;
  scene.bodies.assign(10'000, {"box", BoxShape{{0.5, 0.5, 0.5}}, 1});
  CHECK_THROWS_AS(run_world(scene, {.duration = 1}), TooManyContacts);
}

TEST_CASE("a solver that there is not is answered with those there are")
{
  CHECK_THROWS_WITH(
      run_world(named_scene("tower_1"), {.solver = "magic", .duration = 0}),
      Catch::Matchers::ContainsSubstring("there is no solver 'magic'; there are direct,"));
}
// [bad]

// [sleep]
TEST_CASE("a tower falls asleep within 2 s, and wakes when it is pushed", "[case:L2]")
{
  GameWorld world(named_scene("tower_5"), solver_named("direct"), true);
  for (int i = 0; i < 120; ++i)
  {
    world.step();
  }
  CHECK(world.is_asleep(1));
  CHECK(world.is_asleep(5));
  apply_force(world, 5, {200, 0, 0});
  world.step();
  CHECK_FALSE(world.is_asleep(1));
  CHECK(world.bodies()[5].motion.velocity.x() > 1);
}
// [sleep]

TEST_CASE("impulses are those of a frame, whatever the substeps of a solver", "[R9]")
{
  for (const char* const solver : {"direct", "soft_steps", "sequential_impulses"})
  {
    for (const int substeps : {1, 4})
    {
      CAPTURE(solver, substeps);
      GameWorld world(named_scene("tower_1"), solver_named(solver, substeps));
      for (int i = 0; i < 120; ++i)
      {
        world.step();
      }
      CHECK(
          carried_in(world)[1] ==
          Catch::Approx(9.81 / 60).epsilon(1e-4)); // springs take their time
    }
  }
}

TEST_CASE("a body that is removed lets fall what stood on it, asleep or not", "[case:L2]")
{
  for (const bool may_sleep : {false, true})
  {
    GameWorld world(named_scene("tower_3"), solver_named("direct"), may_sleep);
    for (int i = 0; i < 120; ++i)
    {
      world.step();
    }
    CHECK(world.is_asleep(2) == may_sleep);
    world.remove(1);
    for (int i = 0; i < 12; ++i)
    {
      world.step();
    }
    // g t²/2 in 0.2 s, and the cube that is gone stays where it was.
    CHECK(world.bodies()[2].motion.center.y() == Catch::Approx(1.5 - 9.81 * 0.02).margin(0.02));
    CHECK(world.bodies()[1].motion.center.y() == Catch::Approx(0.5).margin(1e-6));
  }
}

TEST_CASE("when the ground is removed, what slept on it wakes and falls", "[case:L2]")
{
  GameWorld world(named_scene("tower_2"), solver_named("direct"), true);
  for (int i = 0; i < 120; ++i)
  {
    world.step();
  }
  world.remove(0);
  world.step();
  CHECK(world.bodies()[1].motion.velocity.y() == Catch::Approx(-9.81 / 60).margin(1e-6));
}

// [cases]
TEST_CASE(
    "what holds and what fails in the world",
    "[case:S3][case:S6][case:S7][case:S8][case:S18][case:S20][case:S21][case:S22]"
    "[case:S23][case:L3][long]")
{
  // Direct, soft steps, warm and cold impulses, positions.
  check_verdicts(
      world_verdicts(), solver_names(),
      {{"S3", {"direct", "soft_steps", "wide_steps", "position_based"}},
       {"S6", {"direct"}},
       {"S7", {"direct", "position_based"}}, // the latter by chance: with 305 kg it falls
       {"S8", {"direct"}},
       {"S18", {"direct", "soft_steps", "wide_steps"}},
       {"S20",
        {"direct", "soft_steps", "wide_steps", "sequential_impulses", "cold_impulses",
         "position_based"}},
       {"S21",
        {"direct", "soft_steps", "wide_steps", "sequential_impulses", "cold_impulses",
         "position_based"}},
       {"S22",
        {"direct", "soft_steps", "wide_steps", "sequential_impulses", "cold_impulses",
         "position_based"}},
       {"a ball over them",
        {"direct", "soft_steps", "wide_steps", "sequential_impulses", "cold_impulses",
         "position_based"}},
       {"S23", {"direct"}},
       {"L3",
        {"direct", "soft_steps", "wide_steps", "sequential_impulses", "cold_impulses",
         "position_based"}}});
}
// [cases]

TEST_CASE("a cube falls asleep while its corners turn at 3 mm/s, not at 5")
{
  // Of 2 mm in half a second: 4 mm/s. A corner of the cube is √3/2 m from its centre.
  const auto is_asleep = [](double corner_speed)
  {
    Scene scene;
    scene.gravity.setZero();
    scene.bodies.push_back({"cube", BoxShape{{0.5, 0.5, 0.5}}, 1});
    scene.bodies.back().angular_velocity = {0, corner_speed / std::sqrt(0.75), 0};
    GameWorld world(scene, solver_named("direct"), true);
    while (world.time() < 2)
    {
      world.step();
    }
    return world.is_asleep(0);
  };
  CHECK(is_asleep(0.003));
  CHECK_FALSE(is_asleep(0.005));
}
