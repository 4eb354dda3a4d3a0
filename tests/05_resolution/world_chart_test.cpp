/// \file
/// What holds for the chart of the world: each solver is run as named, and how far bodies go is
/// right.

#include "05_resolution/world_chart/trial/world_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

TEST_CASE("the farthest of two bodies, moved by 3-4-0 and by 1, is 5 m away")
{
  Scene scene;
  scene.bodies.push_back({"a", SphereShape{1}, 1});
  scene.bodies.push_back({"b", SphereShape{1}, 1});
  Frame frame = first_frame(scene);
  frame.bodies[0].position = {3, 4, 0};
  frame.bodies[1].position = {1, 0, 0};
  CHECK(farthest(scene, frame) == 5);
}

TEST_CASE("a run that is charted ends where the same run ends by itself")
{
  const Scene scene = named_scene("tower_3");
  const auto runs = charted_runs(scene, 0.5, {{"soft steps", "soft_steps", 4}}, 1);
  World world(scene, solver_named("soft_steps", 4));
  for (int i = 0; i < 30; ++i)
  {
    world.step();
  }
  const FarthestMove move = farthest_move(world);
  CHECK(runs[0].end.moved >= move.along);
  CHECK(runs[0].end.moved <= std::hypot(move.along, move.sideways));
  CHECK(runs[0].end.overlap == deepest_overlap(world));
  CHECK(runs[0].end.load_error == load_error(scene, carried_in(world)));
  CHECK(runs[0].seconds > 0);
}

#if defined(COOKBOOK_HAS_BULLET)
TEST_CASE("Bullet's tower of three carries its weight to a hundredth, by its own count", "[peers]")
{
  const Scene scene = named_scene("tower_3");
  BulletWorld world(scene);
  for (int i = 0; i < 300; ++i)
  {
    world.step();
  }
  CHECK(load_error(scene, world.carried()) < 0.01);
  CHECK(world.deepest_overlap() < 0.01);
}
#endif
