/// \file
/// \brief What holds for statistics, Pareto fronts and timing.

#include "tools/measure/cost_chart.hpp"
#include "tools/measure/pareto.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/measure/timing.hpp"

#include "tests/catch.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

using namespace cookbook::measure;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace

TEST_CASE("of ten numbers the 90th percentile is the ninth, the 91st the tenth", "[percentile]")
{
  const std::vector<double> values{7, 3, 10, 1, 5, 2, 9, 4, 8, 6};
  CHECK(percentile(values, 90) == 9);
  CHECK(percentile(values, 91) == 10);
  CHECK(percentile(values, 100) == 10);
  CHECK(percentile(values, 1) == 1);
  CHECK(percentile({42}, 50) == 42);
}

TEST_CASE("a percentile of nothing, of NaN or of 0 percent is refused", "[percentile]")
{
  CHECK_THROWS_AS(percentile({}, 50), std::invalid_argument);
  CHECK_THROWS_AS(percentile({1, not_a_number}, 50), std::invalid_argument);
  CHECK_THROWS_AS(percentile({1}, 0), std::invalid_argument);
  CHECK_THROWS_AS(percentile({1}, 101), std::invalid_argument);
}

TEST_CASE("the median of 3, 1, 2 is 2, of 4, 1, 3, 2 it is 2.5", "[median]")
{
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  CHECK_THROWS_AS(median({}), std::invalid_argument);
}

TEST_CASE("one NaN among a hundred and one errors is an infinite maximum", "[percentile]")
{
  std::vector<double> errors(100, 0.5);
  errors.push_back(not_a_number);
  CHECK(error_statistics(errors).p99 == 0.5);
  CHECK(error_statistics(errors).maximum == infinity);
}

TEST_CASE("of five methods the three that none beats are the front", "[pareto_front]")
{
  // (2, 9) is beaten by (1, 8), (5, 2) by (4, 2).
  const std::vector<CostAndError> methods{{4, 2}, {2, 9}, {1, 8}, {5, 2}, {9, 1}};
  CHECK(pareto_front(methods) == std::vector<std::size_t>{2, 0, 4});
}

TEST_CASE("a method that fails is never on the front, however cheap", "[pareto_front]")
{
  CHECK(pareto_front({{1, infinity}, {2, not_a_number}, {3, 4}}) == std::vector<std::size_t>{2});
  CHECK(pareto_front({{1, infinity}}).empty());
  CHECK(pareto_front({}).empty());
}

TEST_CASE("an error that is a tenth less is no reason to pay more", "[pareto_front]")
{
  CHECK(pareto_front({{1, 1}, {2, 0.9}, {3, 0.7}}) == std::vector<std::size_t>{0, 2});
}

TEST_CASE("of two equal methods the first is on the front", "[pareto_front]")
{
  CHECK(pareto_front({{1, 1}, {1, 1}}) == std::vector<std::size_t>{0});
}

TEST_CASE("the knee of costs 1, 10, 100 with errors 1000, 1, 0.1 is at cost 10", "[knee]")
{
  // In decades: (0, 3), (1, 0), (2, −1). The line has y = 1 at x = 1; the point is 1 below it.
  const std::vector<CostAndError> methods{{1, 1000}, {10, 1}, {100, 0.1}};
  CHECK(knee(methods, {0, 1, 2}, 1e-9) == 1);
}

TEST_CASE("the knee of a front of one point is that point", "[knee]")
{
  CHECK(knee({{5, 5}}, {0}, 1e-9) == 0);
  CHECK(knee({{5, 5}, {9, 1}}, {0, 1}, 1e-9) == 0); // and of two, the cheaper
  CHECK_THROWS_AS(knee({}, {}, 1e-9), std::invalid_argument);
}

TEST_CASE("the knee of errors 100, 1 and none, counted as 0.1, is the middle one", "[knee]")
{
  CHECK(knee({{1, 100}, {10, 1}, {1000, 0}}, {0, 1, 2}, 0.1) == 1);
}

TEST_CASE("of methods with one answer only the cheapest is on the front", "[pareto_front]")
{
  // A method in float and in double, and one that the double beats: the float stands alone.
  CHECK(pareto_front({{1, 9, "a"}, {2, 1, "a"}, {3, 5, "b"}}) == std::vector<std::size_t>{0});
  CHECK(pareto_front({{1, 9, "a"}, {2, 1, "a"}, {3, 0.5, "b"}}) == std::vector<std::size_t>{0, 2});
  CHECK(pareto_front({{1, infinity, "a"}, {2, 1, "a"}}) == std::vector<std::size_t>{1});
  CHECK(method_of("box_box, double") == "box_box");
}

TEST_CASE("a time whose usual value is more than half as much again is doubtful", "[doubtful]")
{
  CHECK(doubtful({{"steady", 10, 14.9}, {"busy", 10, 15.1}}) == std::vector<std::size_t>{1});
  CHECK(doubtful({{"unknown", not_a_number, 1}}) == std::vector<std::size_t>{0});
}

TEST_CASE("a whole that costs half of its part makes both doubtful", "[doubtful]")
{
  const std::vector<Timing> timings{{"part", 100, 100}, {"whole", 50, 50}, {"other", 1, 1}};
  CHECK(doubtful(timings, {{"whole", "part"}}) == std::vector<std::size_t>{0, 1});
  CHECK(doubtful(timings, {{"part", "whole"}, {"whole", "absent"}}).empty());
}

TEST_CASE("800 operations in 4 ns are doubtful where the peak is 160 a nanosecond", "[doubtful]")
{
  const std::vector<AtLeast> limits{{"batch", "peak", 800}};
  CHECK(doubtful({{"batch", 4, 4}, {"peak", 1 / 160.0, 1 / 160.0}}, limits).size() == 2);
  CHECK(doubtful({{"batch", 6, 6}, {"peak", 1 / 160.0, 1 / 160.0}}, limits).empty());
}

TEST_CASE("a stream that is five times as quick as a plain copy is doubtful", "[doubtful]")
{
  const std::vector<AtLeast> limits{{"stream", "copy"}};
  CHECK(doubtful({{"stream", 2, 2}, {"copy", 10, 10}}, limits).size() == 2);
}

TEST_CASE(
    "a time that is not known is told as a busy machine, and is no point of a chart", "[busy]")
{
  CHECK(time_text(12.34) == "12");
  CHECK(time_text(not_a_number) == "machine was busy");
  cookbook::plot::Chart chart("c", "", {"ns"}, {"error"});
  draw_methods(chart, {{{"quick", 1, 1}, {1, 2}, {}}, {{"slow", not_a_number, 9}, {1, 1}, {}}});
  const std::string svg = chart.svg();
  CHECK(svg.find(">quick<") != std::string::npos);
  CHECK(svg.find("slow: machine was busy.") != std::string::npos);
  CHECK(svg.find(">slow<") == std::string::npos);
}

TEST_CASE("timing gives every method a time above zero, in the order asked for", "[timing]")
{
  double sum = 0;
  const auto count_to = [&sum](int end)
  {
    return [&sum, end]
    {
      for (int i = 0; i < end; ++i)
      {
        sum += std::sqrt(i);
      }
      keep(sum);
    };
  };
  const std::vector<Timing> timings = time_interleaved(
      {{"thousand", count_to(1000), 1000}, {"ten", count_to(10), 10}}, {3, 0.0001});
  REQUIRE(timings.size() == 2);
  CHECK(timings[0].name == "thousand");
  CHECK(timings[1].name == "ten");
  CHECK_FALSE(timings[0].ns <= 0); // NaN where the machine was busy
  CHECK(timings[0].usual >= 0);
}

TEST_CASE("what cannot be is timed three times, and has no time then", "[timing]")
{
  int runs = 0;
  const auto run = [&runs] { ++runs; };
  // Each at least twice the other: impossible.
  const std::vector<Timing> timings =
      time_interleaved({{"a", run, 1}, {"b", run, 1}}, {1, 0}, {{"a", "b", 2}, {"b", "a", 2}});
  CHECK(std::isnan(timings[0].ns));
  CHECK(std::isnan(timings[1].ns));
  CHECK(runs == 2 + 3 * 2); // once each to find how many runs take as long as asked
}

TEST_CASE("waiting is no processor time", "[timing]")
{
  const double start = processor_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(processor_seconds() - start < 0.01);
}

TEST_CASE("the machine's line names compiler and flags", "[timing]")
{
  CHECK(machine_line().find("one thread, least processor time; ") != std::string::npos);
}
