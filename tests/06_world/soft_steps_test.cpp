/// \file
/// Soft steps: a cube sinks as a spring says, twice the substeps sink a quarter, towers stand.

#include "06_world/contacts/start_body.hpp"
#include "06_world/islands/free_flight.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/soft_steps/trial/corner_spin.hpp"
#include "06_world/soft_steps/trial/soft_steps_figures.hpp"
#include "06_world/soft_steps/trial/tall_towers.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace cookbook;

WorldRun softly(const std::string& scene, int substeps, double duration)
{
  return run_world(
      named_scene(scene), {.solver = "soft_steps", .substeps = substeps, .duration = duration});
}

} // namespace

// [spring]
TEST_CASE("a cube on soft contacts sinks by g / ω², as on a spring of their frequency", "[R14]")
{
  for (const int substeps : {2, 4, 8})
  {
    const double rate = 60.0 * substeps;
    const double frequency = 2 * std::numbers::pi * 0.125 * rate;
    const double sink = 9.81 / (frequency * frequency);
    CHECK(softly("tower_1", substeps, 3).overlap == Catch::Approx(sink).epsilon(1e-6));
  }
}
// [spring]

// [warm_starting]
TEST_CASE("a turn is noticed sooner where moments differ: a cube's at 0.05, a needle's at 0.0022")
{
  const auto turns = [](const Vector3<double>& half, double angle)
  {
    RigidBody body = rigid_body(box_body("box", half, {0, 0, 0}));
    body.motion.angular_velocity = Vector3<double>(0, angle, 0) * 240;
    return turns_too_far(body, 1.0 / 240);
  };
  CHECK(!turns({1, 1, 1}, 0.0499));
  CHECK(turns({1, 1, 1}, 0.0501));
  const double moments = (1 + 0.0001) / 0.0002; // of a needle of 1 : 100, one over the other
  CHECK(!turns({1, 0.01, 0.01}, 0.999 * std::sqrt(0.025 / moments)));
  CHECK(turns({1, 0.01, 0.01}, 1.001 * std::sqrt(0.025 / moments)));
  RigidBody sphere = rigid_body(ball_body("ball", 1, {0, 0, 0}));
  sphere.motion.angular_velocity.x() = 1000;
  CHECK(!turns_too_far(sphere, 1));
  CHECK(!turns_too_far(rigid_body(ground()), 1));
}

TEST_CASE("what would give a needle energy that turns is forgotten; what would take some is given")
{
  // The needle's energy before and after, and what its point keeps.
  const auto pushed = [](double down, double spin, std::size_t number)
  {
    SceneBody needle = box_body("needle", {0.1, 0.001, 0.001}, {0, 0.001, 0});
    needle.velocity.y() = -down;
    needle.angular_velocity.y() = spin;
    std::array<RigidBody, 2> bodies{rigid_body(ground()), rigid_body(needle)};
    WorldPoint point{.anchor_b = {0, -0.001, 0}, .warm_start_impulse = 1};
    if (number == 0)
    {
      std::swap(bodies[0], bodies[1]);
      std::swap(point.anchor_a, point.anchor_b);
    }
    std::array<WorldContact, 1> contacts{
        WorldContact{0, 1, 0.6, 0, {0, number == 0 ? -1.0 : 1.0, 0}, {point}}};
    const std::array<int, 1> movable{static_cast<int>(number)}, contact{0};
    SolverScratch room;
    const IslandView view{bodies, contacts, {0, 0, 0}, room};
    const Island island{movable, contact};
    const std::span<IslandPoint> points = points_of(view, island);
    const double before = kinetic_energy(bodies[number]);
    warm_start(view, island, 1.0 / 240, points);
    return std::array<double, 3>{before, kinetic_energy(bodies[number]), points[0].impulse};
  };
  // 1 N s on 1 kg: from rest it gives half a joule, and from 2 m/s it takes 1.5 J.
  for (const std::size_t number : {std::size_t(0), std::size_t(1)})
  {
    const auto [resting, forgotten, nothing] = pushed(0, 1, number);
    CHECK(forgotten == Catch::Approx(resting).epsilon(1e-12));
    CHECK(nothing == 0);
    const auto [still, lifted, kept_still] = pushed(0, 0, number);
    CHECK(lifted - still == Catch::Approx(0.5));
    CHECK(kept_still == 1);
    const auto [coming, braked, kept] = pushed(2, 1, number);
    CHECK(coming - braked == Catch::Approx(1.5));
    CHECK(kept == 1);
  }
}
// [warm_starting]

TEST_CASE(
    "in small steps a plate of 1 kg sinks by its load over its springs, and 100 kg go through it",
    "[R1][R14]")
{
  const auto sunk = [](const char* solver, double mass) // [m]: the plate, and the crate on it
  {
    Scene scene;
    scene.bodies = {
        ground(), box_body("plate", {0.2, 0.01, 0.2}, {0, 0.01, 0}),
        box_body("crate", {0.5, 0.5, 0.5}, {0, 0.52, 0}, mass)};
    const WorldRun run = run_world(scene, {.solver = solver, .duration = 5, .keeps_frames = true});
    const std::vector<BodyState>& bodies = run.frames.back().bodies;
    return std::array<double, 2>{0.01 - bodies[1].position.y(), 0.52 - bodies[2].position.y()};
  };
  // Corners of the plate are 20 cm from its middle along x and z, and feel K = 1/m + 2 · 0.2² / I.
  const double plate = 1 + 0.08 / ((0.04 + 0.0001) / 3), crate = 0.1 + 0.08 / (10 / 6.0);
  const double frequency = 2 * std::numbers::pi * 0.125 * 240, four = 4 * frequency * frequency;
  const double below = 11 * 9.81 * plate / four, above = 10 * 9.81 * (plate + crate) / four;
  for (const char* solver : {"soft_steps", "wide_steps"})
  {
    CAPTURE(solver);
    const auto [low, high] = sunk(solver, 10);
    CHECK(low == Catch::Approx(below).epsilon(0.002));
    CHECK(high == Catch::Approx(below + above).epsilon(0.002));
    CHECK(sunk(solver, 100)[1] > 0.02);
  }
  CHECK(sunk("direct", 100)[1] < 1e-6);
}

// [R16]
TEST_CASE("twice the substeps let a tower of five sink a quarter as far", "[R16][long]")
{
  const double eight = softly("tower_5", 8, 5).sink, sixteen = softly("tower_5", 16, 5).sink;
  // The tower still creeps a little, so the law holds to 5 %.
  CHECK(eight / sixteen == Catch::Approx(4).epsilon(0.05));
}
// [R16]

// [stand]
TEST_CASE(
    "fifteen cubes dropped 10 cm apart stand for 20 s with 8 substeps, with 4 if arms are kept",
    "[case:S3][long]")
{
  // Fifteen gaps of 10 cm close. Between two cubes a spring is half as stiff as on the ground, so
  // that the top sinks by 15 + 2 (14 + … + 1) times as much as a single cube.
  const Scene scene = named_scene("tower_dropped");
  const WorldRun stands = run_world(
      scene, {.solver = "soft_steps", .substeps = 8, .duration = 20, .keeps_frames = true});
  const double frequency = 2 * std::numbers::pi * 0.125 * 60 * 8;
  double height = 0;
  for (std::size_t cube = 1; cube <= 15; ++cube)
  {
    const double load = (16.0 - double(cube)) * 9.81 / (frequency * frequency);
    height += 1 - (cube == 1 ? load : 2 * load);
    const BodyState& body = stands.frames.back().bodies[cube];
    CAPTURE(cube);
    CHECK(body.position.y() == Catch::Approx(height - 0.5).margin(1e-3));
  }
  CHECK(stands.drift < 0.05); // it creeps sideways, and has not fallen
  CHECK(lean(scene, {.substeps = 4}) < 0.1);
  CHECK(lean(scene, {.substeps = 4, .anchor_lag = 0}) > 5);
}

TEST_CASE("a cube .5 m deep in another is pushed out at no more than 4 m/s", "[case:S18]")
{
  const Scene scene = named_scene("overlap");
  const WorldRun run = run_world(
      scene, {.solver = "soft_steps", .substeps = 4, .duration = 2, .keeps_frames = true});
  double fastest = 0;
  for (const Frame& frame : run.frames)
  {
    for (const BodyState& body : frame.bodies)
    {
      fastest = std::max(fastest, body.velocity.norm());
    }
  }
  CHECK(fastest <= 4);
  CHECK(run.overlap <= 0.01);
}
// [stand]

TEST_CASE(
    "a cube under 100 kg is pressed in by less than 2 cm after 5 s of 8 substeps", "[case:S5]")
{
  CHECK(softly("heavy_on_light_100", 8, 5).overlap < 0.02);
}

// [R35]
namespace
{

/// How stiff the joints of a column of cubes have to be, in parts of the moment m g a, so that it
/// is just about to bend: what leans loads the joints, which then have to hold that very leaning.
double critical_stiffness(std::size_t cubes)
{
  std::vector<double> leaning(cubes, 1);
  double stiffness = 0;
  for (int round = 0; round < 40; ++round) // each leaves less than a fifth of what is not yet so
  {
    // Who leans lowers the half of itself and all above.
    const auto moment_of = [&](std::size_t i) { return (double(cubes - i) - 0.5) * leaning[i]; };
    double moment = 0, turn = 0;
    for (std::size_t i = 0; i < cubes; ++i)
    {
      moment += moment_of(i);
    }
    for (std::size_t i = 0; i < cubes; ++i)
    {
      turn += moment / (i == 0 ? 2 : 1); // on the ground a corner feels one cube, not two
      moment -= moment_of(i);
      leaning[i] = turn;
    }
    stiffness = turn;
    std::for_each(leaning.begin(), leaning.end(), [turn](double& each) { each /= turn; });
  }
  return stiffness;
}

} // namespace

TEST_CASE("cubes on springs lose their balance where the formula says, to 0.2 / n cubes", "[R35]")
{
  for (const std::size_t cubes : {5U, 9U, 15U, 24U, 38U})
  {
    for (const double edge : {0.01, 1.0})
    {
      // A joint is as stiff as S a² and a corner feels m/8, so that ω² = 8 g stiffness / a.
      const double in_radians = std::sqrt(8 * 9.81 * critical_stiffness(cubes) / edge);
      const double formula = tallest_tower(edge, in_radians / (2 * std::numbers::pi), 9.81);
      CHECK(formula == Catch::Approx(double(cubes)).margin(0.2 / double(cubes)));
    }
  }
}

TEST_CASE(
    "towers a cube or two lower than the formula stand, as much higher they fall", "[R35][long]")
{
  for (const int substeps : {2, 4})
  {
    const double most = tallest_under(substeps);
    CHECK(lean(int(most) - 1, substeps) < 0.1);
    CHECK(lean(int(most) + 2, substeps) > 1);
  }
}
// [R35]

TEST_CASE("of cubes of 10 cm and 4 substeps six stand on each other, not eight", "[R35][long]")
{
  CHECK(tallest_tower(0.1, frequency_under(4), 9.81) == Catch::Approx(7.08).margin(0.01));
  const auto tower = [](int cubes)
  {
    Scene scene{.bodies = {{.name = "ground", .shape = PlaneShape{{0, 1, 0}, 0}}}};
    for (int i = 0; i < cubes; ++i)
    {
      scene.bodies.push_back(
          {.name = std::to_string(i),
           .shape = BoxShape{{0.05, 0.05, 0.05}},
           .mass = 7,
           .position = {0, 0.1 * i + 0.05, 0}});
    }
    return lean(scene, {.substeps = 4, .anchor_lag = 0});
  };
  CHECK(tower(6) < 0.01);
  CHECK(tower(8) > 0.1);
}

TEST_CASE("9/4 of the square of the first zero of J of order -1/3 is Greenhill's number", "[R35]")
{
  const double at =
      std::sqrt(4.0 / 9 * std::pow(tallest_tower(8.0, 0.5 / std::numbers::pi, 1.0), 3));
  const auto bessel = [](double x)
  {
    double sum = 0, power = std::pow(x / 2, -1.0 / 3), factorial = 1;
    for (int i = 0; i < 20; ++i, power *= -x * x / 4, factorial *= i)
    {
      sum += power / (factorial * std::tgamma(i + 2.0 / 3));
    }
    return sum;
  };
  CHECK(std::abs(bessel(at)) < 1e-14);
  CHECK(bessel(at - 1) > 0.1); // and none before it: it falls from infinity
}

// [lagged_anchors]
TEST_CASE(
    "towers of 20 and 30 cubes stand for 20 s of 4 substeps if arms are kept", "[case:S2][long]")
{
  for (const std::string name : {"tower_20", "tower_30"})
  {
    CAPTURE(name);
    const Scene scene = named_scene(name);
    CHECK(lean(scene, {.substeps = 4}) < 0.5);
    // In float one of thirty leans by up to its own width, by chance to one side or the other.
    const double wide_lean = name == "tower_20" ? 0.5 : 1;
    CHECK(
        run_world(scene, {.solver = "wide_steps", .substeps = 4, .duration = 20}).drift <
        wide_lean);
    CHECK(lean(scene, {.substeps = 4, .anchor_lag = 0}) > 5);
  }
}

TEST_CASE("what it costs: a cube 0.2° past its balance takes 0.7 s longer to fall, 2° past it as "
          "long, to "
          "a frame")
{
  const auto time_to_fall = [](double past, double anchor_lag)
  {
    const double angle = (45 + past) * std::numbers::pi / 180;
    SceneBody cube{.name = "cube", .shape = BoxShape{{0.5, 0.5, 0.5}}, .mass = 1};
    cube.orientation = {std::cos(angle / 2), 0, 0, std::sin(angle / 2)};
    cube.position = {0, (std::sin(angle) + std::cos(angle)) / 2, 0};
    const Scene scene{.bodies = {{.name = "ground", .shape = PlaneShape{{0, 1, 0}, 0}}, cube}};
    GameWorld world(scene, soft_solver({.substeps = 4, .anchor_lag = anchor_lag}));
    while (world.bodies()[1].motion.center.y() > 0.51 && world.time() < 10)
    {
      world.step();
    }
    return world.time();
  };
  const double kept = SoftSettings{}.anchor_lag;
  CHECK(time_to_fall(0.2, kept) - time_to_fall(0.2, 0) == Catch::Approx(0.7).margin(0.1));
  CHECK(std::abs(time_to_fall(2, kept) - time_to_fall(2, 0)) < 1.01 / 60);
}

// [lagged_anchors]

// [lagged_arms]
TEST_CASE(
    "a slab of 4 cm by 1 m is tipped over at 0.17 rad/s, not at 0.15, by arms of either kind",
    "[long]")
{
  SceneBody slab{.name = "slab", .shape = BoxShape{{0.02, 0.5, 0.25}}, .mass = 1};
  slab.position = {0, 0.5, 0};
  for (const double anchor_lag : {0.0, SoftSettings{}.anchor_lag})
  {
    for (const double spin : {0.15, 0.17})
    {
      slab.angular_velocity = {0, 0, -spin};
      slab.velocity = {0.5 * spin, 0, 0};
      const Scene scene{.bodies = {{.name = "ground", .shape = PlaneShape{{0, 1, 0}, 0}}, slab}};
      // What stands has gone aside by less than half a metre, what lies by the height of its
      // centre.
      CHECK((lean(scene, {.anchor_lag = anchor_lag}) > 0.4) == (spin > 0.16));
    }
  }
}

TEST_CASE(
    "arms of a cube are taken anew after 0.07 rad, or at 0.06 rad/s; those of a ball do not turn")
{
  const SceneBody cube{.name = "cube", .shape = BoxShape{{0.5, 0.5, 0.5}}, .mass = 1};
  const double step = 1.0 / 60;
  SceneBody slab = cube;
  slab.shape = BoxShape{{0.5, 0.05, 0.3}};
  const auto keeps = [](const SceneBody& of, double turn, double spin)
  {
    RigidBody body = rigid_body(of);
    body.motion.angular_velocity = {0, 0, spin};
    turn_by(body, turn * Vector3<double>(1, 2, 2) / 3);
    update_lagged_anchors(body, 0.07);
    return body.lagged_orientation.coeffs() == Quaternion<double>::Identity().coeffs();
  };
  CHECK(keeps(cube, 0.0699, 0.0599));
  CHECK_FALSE(keeps(cube, 0.0701, 0.0599));
  CHECK_FALSE(keeps(cube, 0.0699, 0.0601));
  CHECK(keeps(cube, 2 * std::numbers::pi - 0.0699, 0)); // the same pose as the other way round
  CHECK_FALSE(keeps(cube, std::numbers::pi, 0));
  CHECK(keeps(slab, 0.00699, 0)); // a tenth as thick as long
  CHECK_FALSE(keeps(slab, 0.00701, 0));

  RigidBody flying = rigid_body(cube);
  flying.motion.angular_velocity = {0.01, 0, 0};
  integrate_free_flight(flying, {{0, -9.81, 0}}, step);
  CHECK(flying.lagged_orientation.coeffs() == flying.orientation.coeffs());

  RigidBody turned = rigid_body(cube);
  turn_by(turned, {0, 0, 0.05});
  const SceneBody sphere_body{.name = "ball", .shape = SphereShape{0.5}, .mass = 1};
  RigidBody sphere = rigid_body(sphere_body);
  turn_by(sphere, {0, 0, 1});
  update_lagged_anchors(sphere, 0.07);
  CHECK(lagged_axes(turned) == Matrix3<double>::Identity());
  CHECK(lagged_axes(sphere) == Matrix3<double>::Identity());
  CHECK(turned.axes != lagged_axes(turned));
  update_lagged_anchors(turned, 0.04);
  CHECK(turned.axes == lagged_axes(turned));
}
// [lagged_arms]

// [torsional_friction]
TEST_CASE("a cube that spins on its corner rests when the corner's moment says, to 3 %")
{
  const Scene cube = cube_on_corner();
  const double right = rests_by_formula(SoftSettings{}.torsional_radius);
  CHECK(rests_after(cube, solver_named("soft_steps", 4)) == Catch::Approx(right).epsilon(0.03));
  CHECK(rests_after(cube, solver_named("wide_steps", 4)) == Catch::Approx(right).epsilon(0.03));
  CHECK(rests_after(cube, soft_solver({.substeps = 4, .torsional_radius = 0})) >= 5);
}

TEST_CASE("corners hold a turn where one point presses, and no ball is in it")
{
  const auto spin_after = [](const SceneBody& body, std::vector<double> impulses)
  {
    std::vector<RigidBody> bodies{rigid_body(ground()), rigid_body(body)};
    bodies[1].motion.angular_velocity = {0, 1, 0};
    WorldContact contact{0, 1, 0.5, 0, {0, 1, 0}, {}};
    for (const double impulse : impulses)
    {
      contact.points.push_back({.anchor_b = {0, -0.5, 0}, .impulse = impulse});
    }
    apply_torsional_friction(bodies, contact, 0.01);
    return bodies[1].motion.angular_velocity.y();
  };
  const SceneBody cube = cube_body("cube", {0, 0.5, 0});
  // 0.5 · 2 N s · 0.01 · 0.5 m against 1/6 kg m²
  CHECK(spin_after(cube, {2}) == Catch::Approx(1 - 0.005 * 6).epsilon(1e-12));
  CHECK(spin_after(cube, {0, 2, 0}) == Catch::Approx(1 - 0.005 * 6).epsilon(1e-12));
  CHECK(spin_after(cube, {2, 1e-9}) == 1);
  CHECK(spin_after(cube, {0, 0}) == 1);
  CHECK(spin_after(cube, {}) == 1);
  CHECK(spin_after(ball_body("ball", 0.5, {0, 0.5, 0}), {2}) == 1);
}
// [torsional_friction]
