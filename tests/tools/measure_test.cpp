/// \file
/// \brief What holds for statistics, Pareto fronts and timing.

#include "tools/measure/pareto.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/measure/timing.hpp"

#include "tests/catch.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

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
  CHECK(timings[0].ns > 0);
  CHECK(timings[1].ns > 0);
}

TEST_CASE("the machine's line names compiler and flags", "[timing]")
{
  CHECK(machine_line().find("one thread; ") != std::string::npos);
}
