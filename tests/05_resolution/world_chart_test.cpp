/// \file
/// What holds for the chart of the world: each solver is run as named, and how far bodies go is
/// right.

#include "05_resolution/world_chart.hpp"

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
  const auto runs = charted_runs(scene, 0.5, {{"soft steps", "soft_steps", 4}});
  World world(scene, solver_named("soft_steps", 4));
  for (int i = 0; i < 30; ++i)
  {
    world.step();
  }
  const FarthestMove move = farthest_move(world);
  CHECK(runs[0].moved >= move.along);
  CHECK(runs[0].moved <= std::hypot(move.along, move.sideways));
  CHECK(runs[0].seconds > 0);
}
