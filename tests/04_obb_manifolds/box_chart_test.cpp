/// \file
/// \brief What holds for the words and tables of the chart and for the other libraries' answers; it
/// measures no time.

#include "04_obb_manifolds/box_chart/trial/batch_and_memory.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_peers.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_steps.hpp"
#include "tools/measure/peak.hpp"

#include "tests/catch.hpp"

#include <limits>

using namespace cookbook;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

measure::ChartedPoint point(const std::string& name, double ns, double error)
{
  return {{name, ns, ns}, {error, error}, {}};
}

/// A rough one, the knee, a fine one in two scalar types, one that fails.
std::vector<measure::ChartedPoint> points()
{
  return {
      point("rough", 10, 1e-2), point("knee", 20, 1e-6), point("fine, float", 80, 2e-7),
      point("fine, double", 90, 1e-15), point("broken", 1, infinity)};
}

bool has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

Obb<float> cube_at(float x, float y, float z)
{
  return {{x, y, z}, Matrix3<float>::Identity(), {1, 1, 1}};
}

} // namespace

TEST_CASE("a wrong verdict takes a method off the chart", "[box_chart]")
{
  BoxAccuracy accuracy;
  accuracy.depth_p99 = 1e-2;
  CHECK(depth_error_of({{}, accuracy}) == 1e-2);
  accuracy.wrong = 1;
  CHECK(depth_error_of({{}, accuracy}) == infinity);
  CHECK(jump_of({{}, accuracy}) == infinity); // nothing compared
}

TEST_CASE("the sentence names the knee, the cheapest and the finest", "[box_chart]")
{
  CHECK(
      measure::knee_sentence(points(), "99 % within", " of the size", 1e-16) ==
      "The knee: knee, at 20 ns a pair, has 99 % within 1e-06 of the size. The cheapest: rough, at "
      "10 ns a pair, has 99 % within 0.01 of the size. The finest: fine, float, at 80 ns a pair, "
      "has 99 % within 2e-07 of the size.");
}

TEST_CASE("ratios are to the fastest peer, and without one a dash", "[box_chart]")
{
  std::vector<measure::TimingRow> rows;
  measure::add_column(rows, {{"ours", 20, 20}, {"peer", 100, 100, true}});
  measure::add_column(rows, {{"ours", std::nan(""), 1}, {"peer", 200, 200, true}});
  const std::string html = html_table(measure::times_table("in cache", {"first", "second"}, rows));
  CHECK(has(html, "<th>in cache [ns a pair]</th><th>first</th><th>× peer</th><th>second</th>"));
  CHECK(has(html, "<td>ours</td><td>20</td><td>5</td><td>machine was busy</td><td>–</td>"));
  rows.pop_back();
  CHECK(has(html_table(measure::times_table("", {"first"}, rows)), "<td>20</td><td>–</td>"));
}

TEST_CASE("246 operations in 3.075 ns are half of a peak of 160 a nanosecond", "[box_chart]")
{
  CHECK(overlap_operations == 246);
  CHECK(
      peak_row("x", 3.075, 1 / 160.0) == std::vector<std::string>{"x", "3.1", "80", "160", "50 %"});
}

TEST_CASE("a core's peak is asked for by lanes that there are", "[box_chart]")
{
  const measure::Timed peak = measure::peak_flops(4);
  CHECK(peak.calls > 0);
  peak.run();
  CHECK_THROWS_AS(measure::peak_flops(5), std::invalid_argument);
}

TEST_CASE("the batch and the recipe with a memory answer as box_box does", "[box_chart]")
{
  const BoxPairLists lists = box_pair_lists(box_workload("random", 50).pairs);
  const std::vector<ManifoldCheck> right = own_contenders()[0].checks(lists);
  std::vector<TimedMethod> same{memory_contender<float>("memory")};
  for (const InstructionSet set : instruction_sets())
  {
    same.push_back(batch_contender(set));
  }
  for (const TimedMethod& each : same)
  {
    CAPTURE(each.name);
    const std::vector<ManifoldCheck> found = each.checks(lists);
    REQUIRE(found.size() == right.size());
    for (std::size_t i = 0; i < right.size(); ++i)
    {
      CHECK(found[i].compared == right[i].compared);
      CHECK(found[i].depth_error == right[i].depth_error);
      CHECK(found[i].rests == right[i].rests);
      CHECK(found[i].points_lost == right[i].points_lost);
    }
    // By the truth, not by box_box: as good as float allows.
    const BoxAccuracy accuracy = box_accuracy(found);
    CHECK(accuracy.wrong == 0);
    CHECK(accuracy.not_finite == 0);
    CHECK(accuracy.compared > 5);
    CHECK(accuracy.points_lost == 0);
    each.prepare(lists)();
  }
}

TEST_CASE("other libraries find that two cubes overlap, and how deep", "[box_chart]")
{
  const BoxPairLists lists = box_pair_lists(
      {{cube_at(0, 0, 0), cube_at(0.5f, 1.75f, 0)}, {cube_at(0, 0, 0), cube_at(3, 0, 0)}});
  for (const TimedMethod& peer : box_peers())
  {
    CAPTURE(peer.name);
    CHECK(peer.peer);
    const BoxAccuracy accuracy = box_accuracy(peer.checks(lists));
    CHECK(accuracy.wrong == 0);
    CHECK(accuracy.not_finite == 0);
    CHECK(accuracy.compared == 1);
    CHECK(accuracy.depth_max <= 1e-6);
    peer.prepare(lists)();
  }
}

TEST_CASE("a step is told beside the row that it is the faster form of", "[box_chart]")
{
  const std::string html = html_table(
      steps_table({{{"plain", 120, 120}, 0}, {{"quick", 40, 40}, 0}, {{"other", 90, 90}, 2}}));
  CHECK(has(html, "<td>quick</td><td>40</td><td>plain</td><td>3</td>"));
  CHECK(has(html, "<td>other</td><td>90</td><td></td><td></td>"));
}
