/// \file
/// How deep what comes down fast ends in others: a tenth of the smaller of them, and where it is
/// more.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/trial/impacts.hpp"
#include "06_world/game_world/trial/world_measures.hpp"
#include "06_world/impacts/toi_island.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/sweeps/deep_overlaps.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;

namespace
{

const Quaternion<double> flat = Quaternion<double>::Identity();
const Quaternion<double> slanted = rotation_by<double>(0.4 * Vector3<double>(3, 1, 7).normalized());

/// How deep a body of a world is in those before it, as a fraction of the smallest size of both.
double deepest_of(const GameWorld& world, int body)
{
  const Scene& scene = world.scene();
  double deepest = 0;
  for (int i = 0; i < body; ++i)
  {
    const double size = 2 * std::min(inner_radius(scene, i), inner_radius(scene, body));
    const RigidBody &one = world.bodies()[index_of(body)], &other = world.bodies()[index_of(i)];
    deepest = std::max(deepest, depth_between(scene, {body, i}, one, other) / size);
  }
  return deepest;
}

/// The same of all movable bodies, at any time of half a second.
double deepest_in_scene(const Scene& scene, const std::string& solver)
{
  GameWorld world(scene, solver_named(solver, solver == "direct" ? 0 : 4));
  double deepest = 0;
  for (int step = 0; step < 30; ++step)
  {
    world.step();
    for (int i = 1; i < static_cast<int>(world.bodies().size()); ++i)
    {
      deepest = std::max(deepest, is_fixed(world.bodies()[index_of(i)]) ? 0 : deepest_of(world, i));
    }
  }
  return deepest;
}

/// What a box of an edge [m] comes down on.
Scene lands_on(const std::string& what, double edge)
{
  const double half = edge / 2, mass = 1000 * edge * edge * edge;
  const Vector3<double> cube = Vector3<double>::Constant(half);
  Scene scene{.bodies = {ground()}};
  if (what == "a fixed box")
  {
    scene.bodies.push_back(box_body("box", cube, {0, half, 0}, 0));
  }
  if (what == "a free box")
  {
    scene.bodies.push_back(box_body("box", cube, {0, half, 0}, mass));
  }
  for (int i = 0; what == "three free boxes" && i < 3; ++i)
  {
    scene.bodies.push_back(box_body(numbered("box", i), cube, {0, (2 * i + 1) * half, 0}, mass));
  }
  if (what == "two free boxes")
  {
    scene.bodies.push_back(box_body("left", cube, {-half, half, 0}, mass));
    scene.bodies.push_back(box_body("right", cube, {half, half, 0}, mass));
  }
  return scene;
}

/// The same with the box, turned somehow, which would reach what it comes down on after some share
/// of the first step.
Scene comes_down(
    const std::string& what, double edge, double speed, double fraction,
    const Quaternion<double>& turned)
{
  Scene scene = lands_on(what, edge);
  const double half = edge / 2;
  const double top = what == "the ground" ? 0 : what == "three free boxes" ? 3 * edge : edge;
  SceneBody box =
      box_body("falling", Vector3<double>::Constant(half), {}, 1000 * std::pow(edge, 3));
  box.orientation = turned;
  const double bounding_radius = half * box.orientation.toRotationMatrix().row(1).cwiseAbs().sum();
  box.position = {0.07 * edge, top + bounding_radius + fraction * speed * scene.step, 0.03 * edge};
  box.velocity.y() = -speed;
  scene.bodies.push_back(box);
  return scene;
}

/// A cube of 20 cm that comes down on one of a hundredth of its mass.
Scene comes_down_on_light(double speed, double fraction, const Quaternion<double>& turned)
{
  Scene scene = comes_down("a free box", 0.2, speed, fraction, turned);
  scene.bodies[1].mass /= 100;
  return scene;
}

/// What is known of the first two bodies of a scene before a step.
std::array<Prediction, 2> ahead_of_first_two(
    const Scene& scene, std::span<const RigidBody> bodies,
    std::span<const ExternalAcceleration> forces = {})
{
  const PredictedStep step{scene, bodies, forces, {}};
  return {predict(step, 0), predict(step, 1)};
}

/// How far they reach for each other, by a margin [m] and by forces.
ContactMargins reach_of_first_two(
    const Scene& scene, double margin, std::span<const ExternalAcceleration> forces = {})
{
  const RigidBody bodies[] = {rigid_body(scene.bodies[0]), rigid_body(scene.bodies[1])};
  std::array<Prediction, 2> prediction = ahead_of_first_two(scene, bodies, forces);
  return predicted_margins({scene, bodies, forces, prediction}, 0, 1, margin);
}

} // namespace

// [predicted_contacts]
TEST_CASE("what a cube will be too deep in is in reach: by the way of a step more than the margin")
{
  const double margin = 2 * 9.81 / 3600, way = 12.0 / 60;
  const auto reach_of_cube =
      [](double separation, double speed, double speed_of_slab, double pull = 0, double spin = 0)
  {
    Scene scene{.bodies = {box_body("slab", {5, 0.5, 5}, {0, -0.5, 0})}};
    scene.bodies.push_back(cube_body("cube", {0, 0.5 + separation, 0}));
    scene.bodies[0].velocity.y() = speed_of_slab;
    scene.bodies[1].velocity.y() = speed;
    scene.bodies[1].angular_velocity.z() = spin;
    ExternalAcceleration forces[2];
    forces[1].acceleration.y() = pull;
    return reach_of_first_two(scene, contact_margin(scene), forces).contact;
  };
  CHECK(reach_of_cube(0.10, -12, 0) == Catch::Approx(margin + way));     // 0.1 deep
  CHECK(reach_of_cube(0.16, -12, 0) == Catch::Approx(margin));           // 0.04 deep
  CHECK(reach_of_cube(0.10, -12, -12) == Catch::Approx(margin));         // both go down
  CHECK(reach_of_cube(0.10, 12, 0) == Catch::Approx(margin));            // it parts
  CHECK(reach_of_cube(0.10, -40, 0) == Catch::Approx(margin));           // it is swept
  CHECK(reach_of_cube(0.10, 0, 0, -720) == Catch::Approx(margin + way)); // a force takes it there
  CHECK(reach_of_cube(-0.06, -1.2, 0) == Catch::Approx(margin));         // 0.02 closer does no harm
  // A turn by 0.3 takes a corner 0.5 (cos 0.3 + sin 0.3 − 1) = 0.125 down, 0.105 deep.
  CHECK(reach_of_cube(0.02, 0, 0, 0, 18) == Catch::Approx(margin + 0.3 * std::sqrt(0.75)));
}

TEST_CASE("a turn takes a corner of a box along, and no point of a ball or of what is fixed")
{
  const auto way_by_turn = [](SceneBody body)
  {
    body.angular_velocity = {0, 0, body.mass > 0 ? 6.0 : 0.0};
    const Scene scene{.bodies = {body}};
    const RigidBody placed = rigid_body(body);
    return predict({scene, {&placed, 1}, {}, {}}, 0).rotation;
  };
  CHECK(way_by_turn(cube_body("cube", {0, 0, 0})) == Catch::Approx(0.1 * std::sqrt(0.75)));
  CHECK(way_by_turn(ball_body("ball", 1, {0, 0, 0})) == 0);
  CHECK(way_by_turn(ground()) == 0);
}
// [predicted_contacts]

TEST_CASE("what will be too deep in a thin plate is in reach, however fast it comes")
{
  Scene scene{.bodies = {box_body("plate", {1, 0.01, 1}, {0, -0.01, 0})}};
  scene.bodies.push_back(cube_body("cube", {0, 0.5 + 10.0 / 60 - 0.002, 0})); // ends 2 mm deep
  scene.bodies[1].velocity.y() = -10;
  for (const double gravity : {9.81, 0.1})
  {
    const double margin = 2 * gravity / 3600;
    const ContactMargins found = reach_of_first_two(scene, margin);
    CHECK(found.contact == Catch::Approx(margin + 10.0 / 60));
    CHECK(found.ghost == margin);
  }
}

TEST_CASE("five balls that touch in space hand all speed on to the last, however slow the first")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double speed : {0.05, 0.5, 5.0})
    {
      Scene scene{.gravity = {0, 0, 0}};
      for (int i = 0; i < 6; ++i)
      {
        scene.bodies.push_back(ball_body(numbered("ball", i), 0.5, {i == 0 ? -0.1 : i, 0, 0}));
        scene.bodies.back().restitution = 1;
      }
      scene.bodies[0].velocity.x() = speed;
      GameWorld world(scene, solver_named(solver));
      while (world.time() < 0.2 / speed + 0.1)
      {
        world.step();
      }
      for (std::size_t i = 0; i < 6; ++i)
      {
        CAPTURE(solver, speed, i);
        CHECK(world.body(i).motion.velocity.x() == Catch::Approx(i < 5 ? 0 : speed).margin(1e-9));
      }
    }
  }
}

TEST_CASE("without gravity a box that gives nothing back stays at the wall that it meets", "[long]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double half : {0.005, 0.05, 0.25, 2.5})
    {
      for (const double speed : {0.03, 0.1, 0.3, 0.5, 1.0, 1.5, 3.0, 5.0})
      {
        for (const double separation : {0.05, 0.137, 0.211})
        {
          Scene scene{.gravity = {0, 0, 0}};
          scene.bodies = {
              box_body("wall", {1, 50, 50}, {1, 0, 0}, 0),
              box_body("box", Vector3<double>::Constant(half), {-half - separation, 0, 0}, 1)};
          scene.bodies[1].velocity.x() = speed;
          GameWorld world(scene, solver_named(solver));
          while (world.time() < separation / speed + 0.5)
          {
            world.step();
          }
          CAPTURE(solver, half, speed, separation);
          // It gets in by a tenth of its way of a step; a step takes away a fifth, springs more.
          const double left = solver == "direct" ? 0.02 : 0.05;
          CHECK(std::abs(world.body(1).motion.velocity.x()) <= left * speed);
        }
      }
    }
  }
}

// [deep_overlaps]
TEST_CASE("a body is swept that a step leaves deeper than 7.5 %, and not by gravity alone")
{
  enum class Slab
  {
    fixed,
    moves
  };
  // A cube or a ball of 20 cm goes from a height over a slab to one, and a distance along it: what
  // is too deep?
  const auto needs_sweep = [](double from, double to, double along, Slab slab, const auto& shape)
  {
    Scene scene{
        .bodies = {
            box_body("slab", {5, 0.5, 5}, {0, -0.5, 0}, 0), ball_body("ball", 0.1, {0, 0, 0})}};
    scene.bodies[0].mass = slab == Slab::moves ? 1 : 0;
    scene.bodies[1].shape = shape;
    std::vector<RigidBody> ends{rigid_body(scene.bodies[0]), rigid_body(scene.bodies[1])};
    const std::array<Prediction, 2> prediction = ahead_of_first_two(scene, ends);
    scene.bodies[1].position = {0, 0.1 + from, 0};
    ends[1].motion.center = {along, 0.1 + to, 0};
    ends[0].motion.center.x() += slab == Slab::moves ? 1e-6 : 0;
    const std::vector<bool> none(2, false);
    const std::vector<std::pair<int, int>> close_pairs{{0, 1}};
    std::vector<Trajectory> trajectories;
    std::vector<double> displacements;
    std::vector<bool> marked;
    StepTrajectories step{scene,         {},    {}, none, none, close_pairs, trajectories,
                          displacements, marked};
    const bool any = has_boxes_to_sweep(step, prediction, ends);
    CHECK(any == (marked[0] || marked[1]));
    return std::pair<bool, bool>(marked[0], marked[1]);
  };
  const BoxShape cube{Vector3<double>::Constant(0.1)};
  const std::pair none(false, false), alone(false, true), both(true, true);
  const double fall = 9.81 / 3600;
  CHECK(needs_sweep(0.01, -0.0151, 0, Slab::fixed, cube) == alone);
  CHECK(needs_sweep(0.01, -0.0151, 0, Slab::moves, cube) == both);
  CHECK(needs_sweep(0.01, -0.0149, 0, Slab::moves, cube) == none);
  CHECK(needs_sweep(0.01, -0.0151, 0, Slab::fixed, SphereShape{0.1}) == alone);
  CHECK(needs_sweep(-0.05, -0.05 - 1.01 * fall, 0.05, Slab::fixed, cube) == alone);
  CHECK(needs_sweep(-0.05, -0.05 - 0.99 * fall, 0.05, Slab::fixed, cube) == none);
  CHECK(needs_sweep(-0.05, -0.04, 0.05, Slab::fixed, cube) == none); // it comes out
}
// [deep_overlaps]

// [impacts]
TEST_CASE(
    "a cube that comes down flat ends no deeper in the ground than a tenth of its edge", "[long]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double edge : {0.2, 1.0, 5.0, 200.0})
    {
      for (const double speed : {0.5, 2.0, 5.0, 30.0, 200.0, 1000.0})
      {
        CAPTURE(solver, edge, speed);
        CHECK(deepest_impact(edge, speed, solver) <= 0.1 * edge);
      }
    }
  }
}

TEST_CASE("nor one turned anyhow; nor one that comes down in one or two boxes, flat or anyhow")
{
  BoxDraw draw(1);
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double edge : {0.2, 1.0, 5.0})
    {
      for (const double speed : {2.0, 5.0, 30.0})
      {
        CAPTURE(solver, edge, speed);
        for (int i = 0; i < inputs(20, 1); ++i)
        {
          const double fraction = draw.between(0, 1);
          const Quaternion<double> turned(draw.rotation());
          for (const std::string what :
               {"the ground", "a fixed box", "a free box", "two free boxes"})
          {
            CAPTURE(what);
            for (const Quaternion<double>& pose : {flat, turned})
            {
              const Scene scene = comes_down(what, edge, speed, fraction, pose);
              CHECK(deepest_in_scene(scene, solver) <= 0.1);
            }
          }
        }
      }
    }
  }
}
// [impacts]

// [corners_first]
TEST_CASE("corner first in boxes, or in a stack of three, a tenth at 5 and at 30 m/s")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const std::string what :
         {"a fixed box", "a free box", "two free boxes", "three free boxes"})
    {
      for (const double speed : {5.0, 30.0})
      {
        BoxDraw draw(2);
        double sum = 0, most = 0;
        const int tries = inputs(200, 2);
        for (int i = 0; i < tries; ++i)
        {
          const double fraction = draw.between(0, 1);
          const double deepest = deepest_in_scene(
              comes_down(what, 0.2, speed, fraction, Quaternion<double>(draw.rotation())), solver);
          sum += deepest;
          most = std::max(most, deepest);
        }
        CAPTURE(solver, what, speed, sum / tries, most);
        CHECK(sum / tries <= 0.06);
        CHECK(most <= 0.1);
      }
    }
  }
}

TEST_CASE("nor where it used to: a box between two that turn was stopped by both, a quarter deep")
{
  BoxDraw draw(2);
  for (int i = 0; i < 1300; ++i)
  {
    const double fraction = draw.between(0, 1);
    const Quaternion<double> turned(draw.rotation());
    if (i == 494 || i == 961 || i == 1291)
    {
      CAPTURE(i);
      const Scene scene = comes_down("three free boxes", 0.2, 30, fraction, turned);
      CHECK(deepest_in_scene(scene, "direct") <= 0.1);
    }
  }
}
// [corners_first]

TEST_CASE("two cubes that a solver has turned round in a step both go on from where they touched")
{
  for (const std::uint32_t seed : {118u, 276u, 799u}) // 17 % deep if only one of them does
  {
    BoxDraw draw(seed);
    const double fraction = draw.between(0, 1);
    const Quaternion<double> turned(draw.rotation());
    CHECK(
        deepest_in_scene(comes_down("a free box", 0.2, 30, fraction, turned), "soft_steps") <= 0.1);
  }
}

// [remove_approach]
TEST_CASE("a light box carries no heavy one along, which goes no farther than its speed takes it")
{
  BoxDraw draw(2);
  for (int i = 0; i < inputs(40, 1); ++i)
  {
    const double fraction = draw.between(0, 1);
    const Quaternion<double> turned(draw.rotation());
    Scene scene = comes_down("two free boxes", 0.2, 5, fraction, turned);
    scene.bodies[1].mass /= 1e4;
    scene.bodies[2].mass /= 1e4;
    GameWorld world(scene, solver_named("direct", 0));
    for (int step = 0; step < 20; ++step)
    {
      const Motion<double> before = world.bodies().back().motion;
      world.step();
      const Motion<double>& after = world.bodies().back().motion;
      const double speed = std::max(before.velocity.norm(), after.velocity.norm());
      CAPTURE(i, step);
      CHECK((after.center - before.center).norm() <= scene.step * speed + 0.004); // not 0.1 more
    }
  }
}
// [remove_approach]

TEST_CASE("a ball at 30 m/s is stopped by the cube that it hits, which turns a little")
{
  for (const double edge : {0.2, 1.0, 5.0})
  {
    for (int i = 0; i < 20; ++i)
    {
      CAPTURE(edge, i);
      Scene scene = comes_down("a free box", edge, 30, (i + 0.5) / 20, flat);
      scene.bodies.back().shape = SphereShape{edge / 2};
      CHECK(deepest_in_scene(scene, "soft_steps") <= 0.1);
    }
  }
}

TEST_CASE("a cube that friction brakes to where it is not swept ends no deeper in a wall either")
{
  for (double speed = 5.8; speed < 6.3; speed += 0.01)
  {
    Scene scene{.bodies = {ground(), box_body("wall", {1, 2, 2}, {2, 2, 0}, 0)}};
    for (const double separation : {0.005, 0.02, 0.05})
    {
      scene.bodies.resize(2);
      scene.bodies.push_back(box_body("cube", {0.1, 0.1, 0.1}, {0.9 - separation, 0.1, 0}));
      scene.bodies.back().velocity.x() = speed;
      CAPTURE(speed, separation);
      CHECK(deepest_in_scene(scene, "direct") <= 0.1);
    }
  }
}

// [at_once]
TEST_CASE("a cube on a stack, or a hundred times as heavy as what it hits, a tenth at 30 m/s, too")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (int i = 0; i < inputs(20, 2); ++i)
    {
      const double fraction = (i + 0.5) / 20;
      CAPTURE(solver, i);
      CHECK(
          deepest_in_scene(comes_down("three free boxes", 0.2, 30, fraction, flat), solver) <= 0.1);
      for (const Quaternion<double>& pose : {flat, slanted})
      {
        CHECK(deepest_in_scene(comes_down_on_light(30, fraction, pose), solver) <= 0.1);
      }
    }
  }
}

TEST_CASE(
    "turned anyhow, no heavy one gets deeper under direct; in small steps 4 % do, to a third",
    "[long]")
{
  const int tries = 200;
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    BoxDraw draw(7);
    double most = 0;
    int deep = 0;
    for (int i = 0; i < tries; ++i)
    {
      const double fraction = draw.between(0, 1);
      const Quaternion<double> turned(draw.rotation());
      const double deepest = deepest_in_scene(comes_down_on_light(30, fraction, turned), solver);
      deep += deepest > 0.1 ? 1 : 0;
      most = std::max(most, deepest);
    }
    CAPTURE(solver, deep, most);
    CHECK(deep <= (solver == "direct" ? 0 : 0.04) * tries); // too deep
    CHECK(most <= 1.0 / 3);
  }
}

TEST_CASE("nor does it get deeper in a light one that bounces a little, and to 12 % in one that "
          "does well")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (int i = 0; i < inputs(20, 2); ++i)
    {
      for (const double restitution : {0.1, 0.3, 0.6})
      {
        CAPTURE(solver, i, restitution);
        Scene scene = comes_down_on_light(30, (i + 0.5) / 20, slanted);
        scene.bodies[1].restitution = restitution;
        CHECK(deepest_in_scene(scene, solver) <= (restitution > 0.5 ? 0.12 : 0.1));
      }
    }
  }
}

TEST_CASE(
    "balls and cubes in a row that do not quite touch hand all speed on to the last", "[long]")
{
  for (const char* const solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const bool cubes : {false, true})
    {
      for (const double separation : {1e-5, 1e-3, 0.004, 0.006, 0.02})
      {
        for (const double speed : {0.5, 2.0, 8.0})
        {
          Scene scene{.bodies = {ground()}};
          for (int i = 0; i < 4; ++i)
          {
            const Vector3<double> place((0.2 + separation) * i - (i == 0 ? 0.5 : 0), 0.1, 0);
            scene.bodies.push_back(
                cubes ? box_body("one", {0.1, 0.1, 0.1}, place) : ball_body("one", 0.1, place));
            scene.bodies.back().restitution = 1;
          }
          scene.bodies[1].velocity.x() = speed;
          for (SceneBody& body : scene.bodies)
          {
            body.friction = 0;
          }
          GameWorld world(scene, solver_named(solver));
          while (world.time() < 0.5 / speed + 1)
          {
            world.step();
          }
          CAPTURE(solver, cubes, separation, speed);
          for (std::size_t i = 1; i < 5; ++i)
          {
            const double kept = i == 4 ? 1 : 0;
            CHECK(std::abs(world.body(i).motion.velocity.x() / speed - kept) <= 1e-3);
          }
        }
      }
    }
  }
}

TEST_CASE("a ball that loses no speed comes back from one that lies just before a wall")
{
  for (const char* const solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double separation : {1e-4, 1e-3, 0.004, 0.008})
    {
      Scene scene{.gravity = {0, 0, 0}};
      scene.bodies = {
          box_body("wall", {0.1, 1, 1}, {0.2 + separation, 0, 0}, 0),
          ball_body("one", 0.1, {0, 0, 0}), ball_body("other", 0.1, {-1, 0, 0})};
      for (SceneBody& body : scene.bodies)
      {
        body.restitution = 1;
      }
      scene.bodies[2].velocity = {3, 0, 0};
      GameWorld world(scene, solver_named(solver));
      while (world.time() < 1)
      {
        world.step();
      }
      CAPTURE(solver, separation);
      CHECK(world.body(1).motion.velocity.norm() <= 1e-6);
      CHECK(world.body(2).motion.velocity.x() == Catch::Approx(-3));
    }
  }
}

TEST_CASE("cubes that lose no speed hand it on to as many at the end of a row")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const int fast : {1, 2, 3, 6})
    {
      Scene scene;
      scene.gravity.setZero();
      for (int i = 0; i < fast + 4; ++i)
      {
        const double x = i < fast ? i - fast - 0.5 : i - fast;
        scene.bodies.push_back(cube_body(numbered("cube", i), {x, 0, 0}));
        scene.bodies.back().restitution = 1;
        scene.bodies.back().velocity.x() = i < fast ? 200 : 0;
      }
      GameWorld world(scene, solver_named(solver, solver == "direct" ? 0 : 4));
      world.step();
      for (int i = 0; i < fast + 4; ++i)
      {
        const double speed = world.bodies()[index_of(i)].motion.velocity.x();
        CAPTURE(solver, fast, i);
        CHECK(speed == Catch::Approx(i < 4 ? 0 : 200).margin(1e-6));
      }
    }
  }
}

TEST_CASE("a sleeping body that is driven along wakes, and goes on in the next steps")
{
  Scene scene;
  scene.gravity.setZero(); // so that cubes half a millimetre apart are no contact
  for (const double x : {-2.0, 0.0, 1.0005})
  {
    scene.bodies.push_back(
        cube_body(numbered("cube", static_cast<int>(scene.bodies.size())), {x, 0, 0}));
  }
  GameWorld world(scene, solver_named("direct", 0), true);
  while (world.time() < 2)
  {
    world.step();
  }
  CHECK(world.is_asleep(2));
  world.set_velocity(0, {100, 0, 0}, {0, 0, 0});
  world.step();
  CHECK_FALSE(world.is_asleep(2));
  const double before = world.bodies()[2].motion.center.x();
  world.step();
  CHECK(
      world.bodies()[2].motion.center.x() - before ==
      Catch::Approx(scene.step * 100 / 3).epsilon(0.02));
}

TEST_CASE(
    "at 5 m/s the weight of the heavy one presses on: a tenth under direct, else 18 %", "[long]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    double deepest = 0;
    for (int i = 0; i < 20; ++i)
    {
      const Scene scene = comes_down_on_light(5, (i + 0.5) / 20, slanted);
      deepest = std::max(deepest, deepest_in_scene(scene, solver));
    }
    CAPTURE(solver);
    CHECK(deepest == Catch::Approx(solver == "direct" ? 0.1 : 0.18).margin(0.02)); // too deep
  }
}
// [at_once]

// [toi_island]
namespace
{

/// Cubes of 1 m and 1 kg in a row, the first of which comes at a speed [m/s] and touches the
/// second.
struct Row
{
  Scene scene{};
  std::vector<double> speeds{}; // [m/s], once they have bounced
  std::size_t driven = 0;       // how many beside those two

  explicit Row(int cubes, double speed = 8)
  {
    for (int i = 0; i < cubes; ++i)
    {
      scene.bodies.push_back(cube_body(numbered("cube", i), {double(i), 0, 0}));
    }
    scene.bodies[0].velocity.x() = speed;
  }

  /// Has them bounce at a time [s] of the step; whether each of the two that touch is reversed.
  void bounce(double time = 0, bool first_reversed = false, bool second_reversed = false)
  {
    std::vector<RigidBody> bodies;
    std::vector<Bounds> bounds;
    for (const SceneBody& body : scene.bodies)
    {
      bodies.push_back(rigid_body(body));
      bounds.push_back({bounds_of(bodies.back(), body.shape, 0), static_cast<int>(bounds.size())});
    }
    BoundsTree tree;
    tree.build(bounds);
    const std::vector<bool> all(bodies.size(), true), none(bodies.size(), false);
    std::vector<bool> deep = none;
    std::vector<Trajectory> trajectories;
    std::vector<double> displacements;
    StepTrajectories step{scene, {}, {}, all, none, {}, trajectories, displacements, deep, &tree};
    set_trajectories(step, bodies);
    trajectories[0].reversed = first_reversed;
    trajectories[1].reversed = second_reversed;
    const ToiEvent touch{time, 0, 1, {1, 0, 0}, {}};
    RigidBody a = bodies[0], b = bodies[1];
    const ToiManifold manifold = toi_manifold(scene, touch, a, b);
    const auto at = [&](int i) { return bodies[index_of(i)]; };
    std::vector<ToiBody> others;
    const double approach = resolve_toi_island(step, touch, manifold, a, b, 0.0, at, others);
    CHECK(approach == Catch::Approx(scene.bodies[0].velocity.x()));
    speeds.clear();
    for (const SceneBody& body : scene.bodies)
    {
      speeds.push_back(body.velocity.x());
    }
    speeds[0] = a.motion.velocity.x();
    speeds[1] = b.motion.velocity.x();
    for (const ToiBody& one : others)
    {
      speeds[index_of(one.number)] = one.body.motion.velocity.x();
    }
    driven = others.size();
  }
};

} // namespace

TEST_CASE("a cube and up to seven more that lie against each other go on at one speed")
{
  for (const int cubes : {2, 3, 5, 8, 12})
  {
    CAPTURE(cubes);
    Row row(cubes, 1e6); // each pair halves the speed: fast enough for all to get too deep
    row.bounce();
    const int together = std::min(cubes, 8);
    CHECK(row.driven + 2 == static_cast<std::size_t>(together));
    for (int i = 0; i < cubes; ++i)
    {
      const double speed = i < together ? 1e6 / together : 0;
      CHECK(std::abs(row.speeds[index_of(i)] - speed) <= (i < together ? 1e4 : 0));
    }
    const double momentum = std::accumulate(row.speeds.begin(), row.speeds.end(), 0.0);
    CHECK(momentum == Catch::Approx(1e6));
  }
}

TEST_CASE("what is fixed is one more, and stops all that are driven into it")
{
  Row row(9, 1e6);
  row.scene.bodies[8].mass = 0;
  row.bounce();
  CHECK(row.driven == 7);
  for (const double speed : row.speeds)
  {
    CHECK(std::abs(speed) <= 2e4);
  }
}

TEST_CASE("a cube of 1 m lies against another, of 1 or 200 m, if it is no more than 1 mm away")
{
  for (const double half : {0.5, 100.0})
  {
    for (const double separation : {0.00099, 0.00101})
    {
      CAPTURE(half, separation);
      Row row(3);
      row.scene.bodies[1].shape = BoxShape{Vector3<double>::Constant(half)};
      row.scene.bodies[1].position.x() = 0.5 + half;
      row.scene.bodies[2].position.x() = 1 + 2 * half + separation;
      row.bounce();
      CHECK(row.driven == (separation < 0.001 ? 1 : 0));
    }
  }
}

TEST_CASE("a slab on six boxes is stopped by all of them, whatever hits it")
{
  Scene scene{.bodies = {ground()}};
  const Vector3<double> cube = Vector3<double>::Constant(0.1);
  for (int i = 0; i < 6; ++i)
  {
    scene.bodies.push_back(box_body(numbered("leg", i), cube, {0.4 * i - 1, 0.1, 0}, 8));
  }
  scene.bodies.push_back(box_body("slab", {1.2, 0.1, 0.2}, {0, 0.3, 0}, 8));
  for (const double mass : {8.0, 80.0})
  {
    Scene hit = scene;
    hit.bodies.push_back(box_body("falling", cube, {0, 0.6, 0}, mass));
    hit.bodies.back().velocity.y() = -30;
    CHECK(deepest_in_scene(hit, "wide_steps") <= 0.1);
    CHECK(deepest_in_scene(hit, "direct") <= 0.1);
  }
}

TEST_CASE("against what is fixed all stop, heavy ones, too")
{
  for (const double mass : {1.0, 10.0})
  {
    Row row(4, 100);
    row.scene.bodies[0].mass = mass;
    row.scene.bodies[3].mass = 0;
    row.bounce();
    CHECK(row.driven == 2);
    for (const double speed : row.speeds)
    {
      CHECK(std::abs(speed) <= 2);
    }
  }
}

TEST_CASE("what bounces well is driven along once one of the two that touch was turned back")
{
  for (const bool first : {false, true})
  {
    for (const bool second : {false, true})
    {
      CAPTURE(first, second);
      Row row(3);
      row.scene.bodies[2].restitution = 0.5;
      row.bounce(0, first, second);
      const bool reversed = first || second;
      CHECK(row.driven == (reversed ? 1 : 0));
      CHECK(row.speeds[1] == Catch::Approx(reversed ? 8.0 / 3 : 4).margin(0.08));
      CHECK(row.speeds[2] == Catch::Approx(reversed ? 8.0 / 3 : 0).margin(0.08));
    }
  }
}

TEST_CASE("not driven along: a ball that bounces well, lies apart, passes, is let through, gets "
          "hardly deeper")
{
  const auto third = [](const auto& change, double time = 0)
  {
    Row row(3);
    change(row.scene);
    const double before = row.scene.bodies[2].velocity.x();
    row.bounce(time);
    CHECK(row.speeds[0] + row.speeds[1] + row.speeds[2] == Catch::Approx(8 + before));
    if (row.driven == 0)
    {
      CHECK(row.speeds[1] == Catch::Approx(4));
      CHECK(row.speeds[2] == before);
    }
    return row.driven;
  };
  const auto nothing = [](Scene&) {};
  const double step = 1.0 / 60;
  CHECK(third(nothing) == 1);
  CHECK(third([](Scene& scene) { scene.bodies[2].position.x() += 0.00099; }) == 1);
  CHECK(third([](Scene& scene) { scene.bodies[2].position.x() += 0.00101; }) == 0);
  CHECK(third([](Scene& scene) { scene.bodies[2].restitution = 0.49; }) == 1);
  CHECK(third([](Scene& scene) { scene.bodies[2].restitution = 0.5; }) == 0);
  CHECK(third([](Scene& scene) { scene.ignored = {{1, 2}}; }) == 0);
  CHECK(third([](Scene& scene) { scene.bodies[0].shape = SphereShape{0.5}; }) == 1);
  CHECK(third([](Scene& scene) { scene.bodies[2].shape = SphereShape{0.5}; }) == 0);
  CHECK(third([](Scene& scene) { scene.bodies[2].velocity.x() = 4; }) == 0);
  CHECK(third([](Scene& scene) { scene.bodies[2].position.y() = 0.9990; }) == 1);
  CHECK(third([](Scene& scene) { scene.bodies[2].position.y() = 0.9996; }) == 0); // a ghost
  CHECK(third(nothing, step - 0.0126) == 1); // at 4 m/s it would get 5 cm deep in 12.5 ms
  CHECK(third(nothing, step - 0.0124) == 0);
}
// [toi_island]

TEST_CASE("what damping stops short of a wall, within a step or over many, does not bounce there")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double damping : {10.0, 100.0, 1000.0})
    {
      for (const double restitution : {0.0, 1.0})
      {
        // It goes on by v / d, and the wall is a tenth farther away.
        const double speed = damping, size = 0.2;
        Scene scene{.gravity = {0, 0, 0}, .bodies = {box_body("wall", {1, 5, 5}, {2.1, 0, 0}, 0)}};
        scene.bodies.push_back(box_body("box", {size, size, size}, {-size, 0, 0}));
        scene.bodies[1].velocity.x() = speed;
        scene.bodies[1].damping = damping;
        scene.bodies[0].restitution = scene.bodies[1].restitution = restitution;
        GameWorld world(scene, solver_named(solver));
        double back = 0;
        for (int i = 0; i < 120; ++i)
        {
          world.step();
          back = std::max(back, -world.body(1).motion.velocity.x());
        }
        CAPTURE(solver, damping, restitution);
        CHECK(back == 0);
        CHECK(world.body(1).motion.center.x() <= 1 - size + 0.1);
        CHECK(world.body(1).motion.center.x() >= -size);
      }
    }
  }
}

TEST_CASE("a ball that falls into a groove between two blocks presses on both and sleeps")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double drop : {0.001, 0.05, 0.5})
    {
      const double rests = 1 + std::sqrt(0.3 * 0.3 - 0.2 * 0.2);
      GameWorld world(
          {.bodies =
               {box_body("left", {0.5, 0.5, 0.5}, {-0.7, 0.5, 0}, 0),
                box_body("right", {0.5, 0.5, 0.5}, {0.7, 0.5, 0}, 0),
                ball_body("ball", 0.3, {0, rests + drop, 0}, 5)}},
          solver_named(solver), true);
      while (world.time() < 3)
      {
        world.step();
      }
      CAPTURE(solver, drop);
      CHECK(world.is_asleep(2));
      CHECK(world.body(2).motion.center.y() == Catch::Approx(rests).margin(0.001));
      REQUIRE(world.contacts().size() == 2);
      CHECK((is_touching(world.contacts()[0]) && is_touching(world.contacts()[1])));
    }
  }
}

TEST_CASE("a smooth ball that rolls over a gap between tiles gains no energy")
{
  // Soft steps let it sink in first: "Tiles and ledges" on the page of the trial.
  for (const std::string solver : {"direct", "wide_steps"})
  {
    for (const double separation : {0.01, 0.02, 0.04, 0.0642, 0.09})
    {
      for (const double speed : {0.1, 0.3, 1.0})
      {
        Scene scene{
            .bodies = {
                box_body("tile", {0.2, 0.1, 0.5}, {-0.2 - separation / 2, -0.1, 0}, 0),
                box_body("next tile", {0.2, 0.1, 0.5}, {0.2 + separation / 2, -0.1, 0}, 0),
                ball_body("ball", 0.2, {-0.15, 0.2, 0}, 3)}};
        for (SceneBody& body : scene.bodies)
        {
          body.friction = 0;
        }
        scene.bodies[2].velocity.x() = speed;
        GameWorld world(scene, solver_named(solver));
        const double before = energy(world);
        const double moves = kinetic_energy(world.body(2));
        while (world.time() < 2.5 && world.body(2).motion.center.x() < 0.2)
        {
          world.step();
          CAPTURE(solver, separation, speed);
          REQUIRE(energy(world) <= before + 1e-3 * moves);
        }
      }
    }
  }
}
