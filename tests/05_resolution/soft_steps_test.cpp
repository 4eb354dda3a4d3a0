/// \file
/// Soft steps: a cube sinks as a spring says, twice the substeps sink a quarter, towers stand.

#include "05_resolution/soft_steps/soft_steps.hpp"
#include "05_resolution/soft_steps/trial/soft_steps_figures.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

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
    "fifteen cubes dropped 10 cm apart stand for 20 s with 8 substeps, not with 4",
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
  CHECK(softly("tower_dropped", 4, 20).sink > 5);
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
