/// \file
/// What holds for the peer: it gets the same scene as ours, and is timed in the same turns.

#include "06_world/game_world/trial/world_cost_measured.hpp"
#include "06_world/scenes/trial/world_scenes.hpp"
#include "06_world/world_chart/trial/world_peer_bullet.hpp"

#include "tests/catch.hpp"

#include <memory>

using namespace cookbook;

TEST_CASE(
    "worlds are timed in turns, step by step, each repetition from a new start, after a first step "
    "that does not count",
    "[peers]")
{
  std::string log;
  const auto world = [&log](const std::string& name) -> TimedWorld
  {
    return {
        name, [&log, name]
        {
          log += "+" + name;
          return [&log, name] { log += name; };
        }};
  };
  const std::vector<double> seconds = step_seconds({world("a"), world("b")}, 3, 2);
  CHECK(log == "+aa+bb+a+bababab+aa+bb+a+bababab");
  REQUIRE(seconds.size() == 2);
  CHECK((seconds[0] >= 0 && seconds[0] < 1 && seconds[1] >= 0 && seconds[1] < 1));
}

#if defined(COOKBOOK_HAS_BULLET)

TEST_CASE("Bullet's cube falls as gravity says, and comes to rest on the ground", "[peers]")
{
  Scene scene = named_scene("tower_1");
  scene.bodies[1].position.y() = 1.5;
  scene.duration = 2;
  const std::vector<Frame> frames = bullet_frames(scene);
  REQUIRE(frames.size() == 121);
  CHECK(frames[12].time == Catch::Approx(0.2));
  // Velocity first, then place: g dt² (1 + 2 + … + 12).
  CHECK(1.5 - frames[12].bodies[1].position.y() == Catch::Approx(9.81 / 3600 * 78).epsilon(1e-5));
  CHECK(frames.back().bodies[1].position.y() == Catch::Approx(0.5).margin(0.01));
  CHECK(frames.back().bodies[0].position.isZero(0));
}

TEST_CASE("in Bullet's world too surfaces meet with the larger restitution", "[peers]")
{
  const Scene scene = named_scene("bounce");
  const std::vector<Frame> frames = bullet_frames(scene);
  double sphere = 0;
  double cube = 0;
  for (const Frame& frame : frames)
  {
    sphere = frame.time > 1.5 && frame.time < 2.6 ? std::max(sphere, frame.bodies[1].position.y())
                                                  : sphere;
    cube =
        frame.time > 0.6 && frame.time < 1.0 ? std::max(cube, frame.bodies[2].position.y()) : cube;
  }
  CHECK(sphere > 4); // restitution 1, of which Bullet keeps 0.92; not 1 · 0
  CHECK(cube == Catch::Approx(0.75).margin(0.1)); // restitution 0.5: a quarter of 1 m
}

TEST_CASE("in Bullet's world too frictions meet as their geometric mean", "[peers]")
{
  Scene scene = named_scene("rolling");
  scene.bodies[0].friction = 0.4;
  scene.bodies[1].friction = 0.1;
  const std::vector<Frame> frames = bullet_frames(scene);
  // It slides with friction 0.2 for 1.02 s, v = 7 − 0.2 g t, then rolls at 5 m/s.
  CHECK(frames[30].bodies[1].velocity.x() == Catch::Approx(7 - 0.2 * 9.81 / 2).epsilon(0.01));
  CHECK(frames.back().bodies[1].velocity.x() == Catch::Approx(5).epsilon(0.01));
}

TEST_CASE("Bullet's tower of 10 falls within 20 s without sleeping, its pyramid stands", "[peers]")
{
  const auto least_height = [](const Scene& scene)
  {
    const Frame last = bullet_frames(scene).back();
    return last.bodies.back().position.y() / scene.bodies.back().position.y();
  };
  CHECK(least_height(named_scene("tower")) < 0.5);
  CHECK(least_height(named_scene("pyramid")) > 0.99);
}

#endif
