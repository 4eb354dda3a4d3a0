/// \file
/// Which bodies touch in a game, from when to when; and a game that was saved by copying its
/// world.

#include "06_world/contact_events/contact_events.hpp"
#include "06_world/game_world/solvers.hpp"
#include "06_world/game_world/world_inputs.hpp"
#include "06_world/scenes/trial/scene_bodies.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

using namespace cookbook;

// [saved]
TEST_CASE("a game saved while crates fall goes on to the bit: put in, shot at, taken out")
{
  for (const char* const solver : {"soft_steps", "direct"})
  {
    Scene scene;
    scene.bodies = {ground(), box_body("table", {1, 0.05, 1}, {0, 1, 0}, 0)};
    GameWorld world(scene, solver_named(solver), true);
    const auto play = [](GameWorld& played, int from, int to)
    {
      for (int frame = from; frame < to; ++frame)
      {
        if (frame % 30 == 0 && frame < 150)
        {
          played.add(box_body("crate", {0.25, 0.2, 0.3}, {0.05 * (frame % 7), 3, 0}, 20));
        }
        if (frame == 170)
        {
          apply_impulse(played, 4, {60, 0, 5}, played.bodies()[4].motion.center);
        }
        if (frame == 200)
        {
          played.remove(1);
        }
        played.step();
      }
    };
    play(world, 0, 100);
    GameWorld saved = world;
    play(world, 100, 400);
    play(saved, 100, 400);
    REQUIRE(world.bodies().size() == 7);
    for (std::size_t i = 0; i < world.bodies().size(); ++i)
    {
      CAPTURE(solver, i);
      CHECK(world.bodies()[i].motion.center == saved.bodies()[i].motion.center);
      CHECK(world.bodies()[i].orientation.coeffs() == saved.bodies()[i].orientation.coeffs());
      CHECK(world.bodies()[i].motion.velocity == saved.bodies()[i].motion.velocity);
    }
    CHECK(world.bodies()[2].motion.center.y() < 0.9); // the table is gone
  }
}
// [saved]

// [contact_events]
TEST_CASE("a cube that falls on another begins to press on it once, and ends when it is taken away")
{
  Scene scene = named_scene("tower_1");
  scene.bodies.push_back(cube_body("late", {0, 2.5, 0}));
  GameWorld world(scene, solver_named("direct"), true);
  ContactEvents watch;
  using Pairs = std::vector<ContactEvents::Pair>;
  Pairs begun, ended;
  const auto watched_until = [&](double time)
  {
    while (world.time() < time)
    {
      world.step();
      watch.update(world.contacts(), world.bodies());
      begun.insert(begun.end(), watch.begun().begin(), watch.begun().end());
      ended.insert(ended.end(), watch.ended().begin(), watch.ended().end());
    }
  };
  watched_until(4);
  CHECK(begun == Pairs{{0, 1}, {1, 2}});
  CHECK(ended.empty());
  CHECK(watch.active() == begun);
  REQUIRE(world.is_asleep(2));
  world.set_velocity(2, {0, 5, 0}, {0, 0, 0});
  watched_until(4.5);
  CHECK(ended == Pairs{{1, 2}});
  CHECK(watch.active() == Pairs{{0, 1}});
}

TEST_CASE("a body in a reused slot ends no contact of the body before it")
{
  GameWorld world(
      {.bodies = {ground(), ball_body("ball", 0.5, {0, 0.5, 0})}}, solver_named("direct"));
  ContactEvents watch;
  const auto look = [&] { watch.update(world.contacts(), world.bodies()); };
  world.step();
  world.step();
  look();
  CHECK(watch.active() == std::vector<ContactEvents::Pair>{{0, 1}});
  world.remove(1);
  world.step();
  const BodyId next = world.add(ball_body("next", 0.5, {5, 0.5, 0}));
  REQUIRE(world.index(next) == 1);
  world.step();
  world.step();
  look();
  CHECK(watch.ended() == std::vector<ContactEvents::Pair>{{0, 1}});
  CHECK(watch.begun() == std::vector<ContactEvents::Pair>{{0, next}});
}
// [contact_events]

namespace
{

/// All impacts of a scene up to a time [s].
std::vector<Impact> impacts_until(double time, const Scene& scene, const std::string& solver)
{
  GameWorld world(scene, solver_named(solver));
  std::vector<Impact> all;
  while (world.time() < time)
  {
    world.step();
    all.insert(all.end(), world.impacts().begin(), world.impacts().end());
  }
  return all;
}

} // namespace

// [hit_events]
TEST_CASE("a ball is heard each time it bounces, at half the speed of the time before")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    Scene scene{.bodies = {ground(), ball_body("ball", 0.5, {3, 20.5, 4}, 10)}};
    scene.bodies[1].restitution = 0.5;
    const std::vector<Impact> heard = impacts_until(15, scene, solver);
    CAPTURE(solver);
    REQUIRE(heard.size() == 6); // the seventh time it is slower than 2 g h = 0.327 m/s
    double speed = std::sqrt(2 * 9.81 * 20);
    for (const Impact& impact : heard)
    {
      CHECK((impact.a == 0 && impact.b == 1));
      CHECK(impact.speed == Catch::Approx(speed).epsilon(0.002));
      CHECK(impact.normal.isApprox(Vector3<double>(0, 1, 0)));
      CHECK((impact.point - Vector3<double>(3, 0, 4)).norm() <= 0.001);
      speed /= 2;
    }
  }
}

TEST_CASE(
    "a cube that comes down on a tower is heard, and where it hops after that, hardly", "[long]")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    for (const double high : {0.05, 1.0, 5.0, 50.0})
    {
      CAPTURE(solver, high);
      Scene scene = named_scene("tower_2");
      scene.bodies.push_back(cube_body("late", {0, 2.5 + high, 0}));
      const std::vector<Impact> heard = impacts_until(6, scene, solver);
      REQUIRE_FALSE(heard.empty());
      CHECK(heard[0].a == 2);
      CHECK(heard[0].b == 3);
      CHECK(heard[0].speed == Catch::Approx(std::sqrt(2 * 9.81 * high)).epsilon(0.01));
      CHECK(std::abs(heard[0].point.y() - 2) <= 0.01);
      for (std::size_t i = 1; i < heard.size() && high < 50; ++i) // from 50 m the tower falls
      {
        CHECK(heard[i].speed < 0.7);
      }
    }
  }
}

TEST_CASE("two balls that meet in flight are heard once, the smaller number first")
{
  Scene scene{.gravity = {0, 0, 0}};
  scene.bodies = {ball_body("right", 0.5, {5, 1, 0}), ball_body("left", 0.25, {-5, 1, 0})};
  scene.bodies[0].velocity = {-30, 0, 0};
  scene.bodies[1].velocity = {10, 0, 0};
  const std::vector<Impact> heard = impacts_until(2, scene, "direct");
  REQUIRE(heard.size() == 1);
  CHECK((heard[0].a == 0 && heard[0].b == 1));
  CHECK(heard[0].speed == Catch::Approx(40));
  CHECK(heard[0].normal.isApprox(Vector3<double>(-1, 0, 0)));
  // They touch after (10 − 0.75) / 40 s, where the left one has come to −5 + 10 t.
  CHECK(heard[0].point.x() == Catch::Approx(-5 + 9.25 / 4 + 0.25));
}

TEST_CASE("without gravity rounding is not heard, and a pair is heard once in a step")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    Scene scene{.gravity = {0, 0, 0}};
    scene.bodies = {ground(), cube_body("cube", {0, 2, 0})};
    scene.bodies[1].velocity = {0, -20, 0};
    CAPTURE(solver);
    const std::vector<Impact> heard = impacts_until(2, scene, solver);
    REQUIRE_FALSE(heard.empty());
    CHECK(heard[0].speed == Catch::Approx(20));
    CHECK(heard.size() <= (solver == "direct" ? 1U : 2U)); // small steps do not stop it at once
    CHECK(heard.back().speed > 0.05); // of the 20 m/s; rounding is less than 1e-4
    CHECK((heard.size() == 1 || heard[1].speed < 0.2));

    // A ball goes to and fro between two others that come from both sides, many times in a step.
    scene.bodies = {
        ball_body("left", 0.5, {-2, 0, 0}, 100), ball_body("right", 0.5, {2, 0, 0}, 100),
        ball_body("between", 0.1, {0, 0, 0}, 0.1)};
    scene.bodies[0].velocity = {40, 0, 0};
    scene.bodies[1].velocity = {-40, 0, 0};
    scene.bodies[2].restitution = 1;
    GameWorld world(scene, solver_named(solver));
    while (world.time() < 0.5)
    {
      world.step();
      CHECK(world.impacts().size() <= 3);
      const auto same = [](const Impact& one, const Impact& other)
      { return one.a == other.a && one.b == other.b; };
      CHECK(
          std::adjacent_find(world.impacts().begin(), world.impacts().end(), same) ==
          world.impacts().end());
    }
  }
}

TEST_CASE("a plank that tips over about one edge is heard as the other comes down")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    const double lean = 0.12;
    Scene scene{.bodies = {ground(), box_body("plank", {0.1, 1, 0.3}, {0, 0, 0}, 10)}};
    scene.bodies[1].position.y() = std::cos(lean) + 0.1 * std::sin(lean);
    scene.bodies[1].orientation = Eigen::AngleAxisd(-lean, Vector3<double>::UnitZ());
    const std::vector<Impact> heard = impacts_until(4, scene, solver);
    CAPTURE(solver);
    REQUIRE(heard.size() == 1);
    // About an edge that stays where it is m g (y - 0.1) = I ω² / 2, with I = m (0.2² + 2²) / 3.
    const double fallen = scene.bodies[1].position.y() - 0.1;
    const double fastest = 2 * std::sqrt(2 * 9.81 * fallen / (4.04 / 3));
    CHECK(heard[0].speed <= fastest);
    CHECK(heard[0].speed >= 0.9 * fastest);
  }
}

TEST_CASE("what stands, rolls or slides is not heard")
{
  for (const std::string solver : {"direct", "soft_steps", "wide_steps"})
  {
    CAPTURE(solver);
    CHECK(impacts_until(5, named_scene("tower_10"), solver).empty());
    CHECK(impacts_until(5, named_scene("incline"), solver).empty());
    CHECK(impacts_until(5, named_scene("rolling"), solver).empty());
    CHECK(impacts_until(3, named_scene("tiles"), solver).empty());
  }
}
// [hit_events]
