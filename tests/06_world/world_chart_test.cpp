/// \file
/// What holds for the chart of the world: each solver is run as named, and how far bodies go is
/// right.

#include "06_world/world_chart/trial/world_chart.hpp"

#include "tests/catch.hpp"

#include <numbers>

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

TEST_CASE("a cube's run is charted with the sink, the overlap and the load of a cube at rest")
{
  // On soft contacts a cube sinks by g / ω², with 4 substeps a frame.
  const double frequency = 2 * std::numbers::pi * 0.125 * 60 * 4;
  const double sink = 9.81 / (frequency * frequency);
  const auto runs = charted_runs(
      named_scene("tower_1"), 3, {{"soft steps", "soft_steps", 4}, {"direct", "direct", 0}}, 1);
  CHECK(runs[0].end.overlap == Catch::Approx(sink).epsilon(1e-6));
  // As it settles it slips aside by a tenth of that: less than a hundredth more, at right angles.
  CHECK(runs[0].end.moved == Catch::Approx(sink).epsilon(1e-2));
  CHECK(runs[0].end.load_error <= 1e-6);
  // On exact ones by that of a load of 1 kg: g h² · 10⁻⁷ / (4 · 0.2).
  const double direct = 9.81 / 3600 * 1e-7 / 0.8;
  CHECK(runs[1].end.overlap == Catch::Approx(direct).epsilon(1e-3).margin(1e-12));
  CHECK(runs[1].end.moved == Catch::Approx(direct).epsilon(1e-3).margin(1e-12));
  CHECK((runs[0].seconds > 0 && runs[1].seconds > 0));
}

TEST_CASE("the charted error of loads is the largest share: 3, 1.9 and 1 kg for 3, 2 and 1")
{
  const Scene scene = named_scene("tower_3");
  const double step = scene.gravity.norm() * scene.step;
  CHECK(load_error(scene, {0, 3 * step, 1.9 * step, step}) == Catch::Approx(0.05));
  CHECK(load_error(scene, {0, 3 * step, 2 * step, step}) <= 1e-15);
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
  CHECK(load_error(scene, world.warm_start_impulse()) < 0.01);
  CHECK(world.deepest_overlap() < 0.01);
}
#endif
