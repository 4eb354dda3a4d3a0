/// \file
/// Who presses on whom in a game, from when to when; and a game that was saved by copying its
/// world.

#include "05_resolution/contact_watch/contact_watch.hpp"
#include "05_resolution/scenes/trial/scene_bodies.hpp"
#include "05_resolution/scenes/trial/world_scenes.hpp"
#include "05_resolution/world/solvers.hpp"
#include "05_resolution/world/world_inputs.hpp"

#include "tests/catch.hpp"

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
    World world(scene, solver_named(solver), true);
    const auto play = [](World& played, int from, int to)
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
    World saved = world;
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

// [contact_watch]
TEST_CASE("a cube that falls on another begins to press on it once, and ends when it is taken away")
{
  Scene scene = named_scene("tower_1");
  scene.bodies.push_back(cube_body("late", {0, 2.5, 0}));
  World world(scene, solver_named("direct"), true);
  ContactWatch watch;
  using Pairs = std::vector<std::pair<int, int>>;
  Pairs begun, ended;
  const auto watched_until = [&](double time)
  {
    while (world.time() < time)
    {
      world.step();
      watch.look(world.contacts());
      begun.insert(begun.end(), watch.begun().begin(), watch.begun().end());
      ended.insert(ended.end(), watch.ended().begin(), watch.ended().end());
    }
  };
  watched_until(4);
  CHECK(begun == Pairs{{0, 1}, {1, 2}});
  CHECK(ended.empty());
  CHECK(watch.pressing() == begun);
  REQUIRE(world.sleeps(2));
  world.set_velocity(2, {0, 5, 0}, {0, 0, 0});
  watched_until(4.5);
  CHECK(ended == Pairs{{1, 2}});
  CHECK(watch.pressing() == Pairs{{0, 1}});
}
// [contact_watch]
