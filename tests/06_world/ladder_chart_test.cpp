/// \file
/// What holds for the chart of the ladder: its worlds are those of the scene, and what they move
/// and hold is counted right.

#include "06_world/ladder_chart/trial/ladder_chart.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

using namespace cookbook;

TEST_CASE("a cube of the ladder's chart moves and overlaps by its sink on soft contacts; R13")
{
  const double frequency = 2 * std::numbers::pi * 0.125 * 60 * 4;
  const double sink = 9.81 / (frequency * frequency);
  for (const LadderMethod& method : ladder_methods())
  {
    if (method.name == "step 3" || method.name == "step 7" ||
        method.name == "GameWorld, soft steps")
    {
      CAPTURE(method.name);
      const LadderWorld world = method.build(scenes::tower(1));
      for (int i = 0; i < 180; ++i)
      {
        world.step();
      }
      CHECK(world.overlap() == Catch::Approx(sink).epsilon(0.01));
      CHECK(world.moved() == Catch::Approx(sink).epsilon(0.02));
    }
  }
}

TEST_CASE("a world of the ladder's chart holds its bodies in memory, and a step of it takes time")
{
  const LadderScene scene{"tower of 3", scenes::tower(3), 0.1, true};
  for (const LadderMethod& method : ladder_methods())
  {
    CAPTURE(method.name);
    CHECK(ladder_end(method, scene).bytes >= sizeof(Body<double>));
  }
  for (const double seconds : ladder_seconds(ladder_methods(), scene, 1))
  {
    CHECK((seconds > 0 || std::isnan(seconds)));
  }
}
