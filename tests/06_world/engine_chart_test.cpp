/// \file
/// What holds for the chart of engines: mean, worst step and settled time are told apart, and each
/// engine moves the scene.

#include "06_world/engine_chart/trial/engine_chart.hpp"

#include "tests/catch.hpp"

#include <set>
#include <string>

using namespace cookbook;

TEST_CASE(
    "ten steps of 1 to 10 s and ten of 20 s cost two bodies 2.75, at most 5, and settled 10 s")
{
  std::vector<double> times(20, 20.0);
  for (std::size_t i = 0; i < 10; ++i)
  {
    times[i] = static_cast<double>(i + 1);
  }
  const SceneCost cost = scene_cost(times, 2);
  CHECK(cost.mean == 2.75);
  CHECK(cost.worst == 5);
  CHECK(cost.settled == 10);
}

TEST_CASE("each engine steps a scene, and each name is a line of its own", "[peers]")
{
  std::set<std::string> lines;
  for (const ChartedSolver& engine : engines())
  {
    CHECK(lines.insert(engine.line).second);
  }
  const auto costs = scene_costs(named_scene("tower_2"), engines(), 0.5, 1);
  REQUIRE(costs.size() == lines.size());
  for (const SceneCost& cost : costs)
  {
    CHECK(cost.mean > 0);
    CHECK(cost.worst >= cost.mean);
    CHECK(cost.settled > 0);
  }
}

TEST_CASE("wide steps are timed in registers of every width")
{
  const std::vector<double> costs = width_costs(named_scene("tower_2"), 0.5, 1);
  REQUIRE(costs.size() == instruction_sets().size());
  CHECK(*std::min_element(costs.begin(), costs.end()) > 0);
}
