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

BoxAccuracy within(double depth)
{
  BoxAccuracy accuracy;
  accuracy.compared = 1;
  accuracy.depth_p99 = depth;
  return accuracy;
}

BoxAccuracy wrong()
{
  BoxAccuracy accuracy = within(1e-9);
  accuracy.wrong = 1;
  return accuracy;
}

/// A rough one, the knee, a fine one, one that fails, and a peer.
std::vector<MeasuredBoxMethod> methods()
{
  return {
      {{"rough", false, {10, 10}}, within(1e-2)},
      {{"knee", false, {20, 20}}, within(1e-6)},
      {{"fine", false, {80, 80}}, within(2e-7)},
      {{"broken", false, {1, 1}}, wrong()},
      {{"peer", true, {100, 200}}, within(0.05)}};
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
  CHECK(depth_error_of(methods()[0]) == 1e-2);
  CHECK(depth_error_of(methods()[3]) == infinity);
  CHECK(jump_of(methods()[0]) == infinity);
}

TEST_CASE("the sentence names the knee, the cheapest and the finest", "[box_chart]")
{
  CHECK(
      box_knee_sentence(methods(), depth_error_of, 0, "99 % within") ==
      "The knee: knee, at 20 ns a pair, has 99 % within 1e-06 of the size. The cheapest: rough, at "
      "10 ns a pair, has 99 % within 0.01 of the size. The finest: fine, at 80 ns a pair, has 99 % "
      "within 2e-07 of the size.");
}

TEST_CASE("ratios are to the fastest peer, and without one a dash", "[box_chart]")
{
  std::vector<MeasuredTimes> all;
  for (const MeasuredBoxMethod& method : methods())
  {
    all.push_back(method.times);
  }
  const std::string html = box_times_html("in cache", {"first", "second"}, all);
  CHECK(has(html, "<th>in cache [ns a pair]</th><th>first</th><th>× peer</th><th>second</th>"));
  CHECK(has(html, "<td>knee</td><td>20</td><td>5</td><td>20</td><td>10</td>"));
  CHECK(has(box_times_html("", {"first"}, {{"alone", false, {1}}}), "<td>1</td><td>–</td>"));
}

// [peak]
TEST_CASE("246 operations in 3 ns are half of a peak of 164 a nanosecond", "[box_chart]")
{
  CHECK(overlap_operations == 246);
  // Told to two digits: 164 as 160.
  CHECK(peak_row("x", 3, 1 / 164.0) == std::vector<std::string>{"x", "3", "82", "160", "50 %"});
}
// [peak]

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
  const std::string html = steps_html({{"plain", 120, 0}, {"quick", 40, 0}, {"other", 90, 2}});
  CHECK(has(html, "<td>quick</td><td>40</td><td>plain</td><td>3</td>"));
  CHECK(has(html, "<td>other</td><td>90</td><td></td><td></td>"));
}
