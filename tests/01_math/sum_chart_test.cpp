/// \file
/// What holds for the lists and products that are timed.

#include "01_math/numbers/trial/whole_numbers.hpp"
#include "01_math/sum_chart/trial/product_chart.hpp"
#include "01_math/sum_chart/trial/sum_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [sum_lists]
TEST_CASE("a timed list has a million floats whose sum in units of 2^-40 is kept exactly", "[sums]")
{
  for (const Signs signs : {Signs::positive, Signs::random, Signs::opposite})
  {
    const SumList list = sum_list(signs, 1);
    REQUIRE(list.numbers.size() == 1000000);
    Whole sum = 0;
    double sizes = 0;
    for (const float x : list.numbers)
    {
      sum += whole(x, 40);
      sizes += std::abs(static_cast<double>(x));
    }
    CHECK(sum == list.sum);
    const double condition = sizes / std::abs(std::ldexp(static_cast<double>(list.sum), -40));
    CHECK((signs == Signs::positive) == (condition < 1.001));
    CHECK((signs == Signs::opposite) == (condition > 1e6));
  }
}

TEST_CASE(
    "of a million floats that nearly all cancel, naive keeps no digit, compensated all", "[sums]")
{
  const std::vector<SumList> lists{sum_list(Signs::opposite, 1)};
  CHECK(sum_errors(sum_methods<float>()[0], lists).maximum > 1e6);
  CHECK(sum_errors(sum_methods<float>().back(), lists).maximum <= 0.5);
  CHECK(
      sum_errors({"twice", [](std::span<const float> x) { return 2 * sum_wide(x); }}, lists).p99 >
      1e6);
}
// [sum_lists]

TEST_CASE("of 1000 times ad − bc = 1, all but the naive way say 1", "[products]")
{
  int naive = 0, right = 0;
  for (const Products& one : unit_products(1000))
  {
    const Whole a = whole(one.a, 0), d = whole(one.d, 0), b = whole(one.b, 0), c = whole(one.c, 0);
    REQUIRE(a * d - b * c == 1);
    naive += difference_naive(one.a, one.d, one.b, one.c) == 1 ? 1 : 0;
    right += difference_split(one.a, one.d, one.b, one.c) == 1 ? 1 : 0;
    right += difference_of_products(one.a, one.d, one.b, one.c) == 1 ? 1 : 0;
  }
  CHECK(naive < 10);
  CHECK(right == 2000);
}
