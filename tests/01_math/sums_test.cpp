/// \file
/// What holds for sums of many numbers, and the numbers that break a way to add.

#include "01_math/numbers/numbers.hpp"
#include "01_math/numbers/trial/whole_numbers.hpp"
#include "01_math/sums/sums.hpp"
#include "01_math/sums/trial/sums_cases.hpp"
#include "01_math/truth/trial/whole_range.hpp"

#include "tests/catch.hpp"
#include "tests/verdicts.hpp"

#include <limits>
#include <numeric>

using namespace cookbook;

namespace
{

/// A sum without rounding, and that of the sizes, as multiples of the smallest number.
struct ExactSum
{
  Whole sum = 0;
  Whole sizes = 0;
};

template <class Real>
ExactSum exact_sum(const std::vector<Real>& numbers)
{
  ExactSum exact;
  for (const Real x : numbers)
  {
    const Whole one = whole(x);
    exact.sum += one;
    exact.sizes += abs(one);
  }
  return exact;
}

/// Whether a sum is off by at most `roundings` u of the sum of the sizes.
template <class Real>
bool is_within(Real answer, const ExactSum& exact, int roundings)
{
  constexpr int digits = std::numeric_limits<Real>::digits;
  // γₙ = n / (2^digits − n)
  return abs(whole(answer) - exact.sum) * (power_of_two(digits) - roundings) <=
         exact.sizes * roundings;
}

/// Whether a sum is off by at most u|sum| + `times` u² of the sum of the sizes.
template <class Real>
bool is_compensated(Real answer, const ExactSum& exact, long times)
{
  const Whole in_u = power_of_two(std::numeric_limits<Real>::digits);
  const Whole error = abs(whole(answer) - exact.sum);
  return error * in_u * in_u <= abs(exact.sum) * in_u + exact.sizes * times;
}

/// Numbers from -1 to 1, or from 0 to 1.
template <class Real>
std::vector<Real> shares(WholeRange<Real>& draw, int count, bool positive)
{
  std::vector<Real> numbers;
  for (int i = 0; i < count; ++i)
  {
    const Real x = draw.fraction();
    numbers.push_back(positive ? std::abs(x) : x);
  }
  return numbers;
}

/// The bound of pairwise: 8 rows, 4 halvings of the columns, and one for each doubling of 128.
int most_roundings(int n)
{
  return 12 + std::max(0, static_cast<int>(std::ceil(std::log2(n / 128.0))));
}

/// A number that counts the additions which the numbers in it have gone through, at most.
struct Counted
{
  int additions = 0; ///< so far

  Counted& operator+=(const Counted& other)
  {
    additions = std::max(additions, other.additions) + 1;
    return *this;
  }
  friend Counted operator+(Counted a, const Counted& b) { return a += b; }
};

} // namespace

// [pairwise_roundings]
TEST_CASE("pairwise, no number goes through more than 12 + ⌈log₂(n / 128)⌉ additions", "[sums]")
{
  for (int n = 128; n < 100000; n += 1 + n / 50)
  {
    const std::vector<Counted> numbers(static_cast<std::size_t>(n));
    CHECK(sum_pairwise<Counted>(numbers).additions <= most_roundings(n));
  }
  CHECK(sum_pairwise<Counted>(std::vector<Counted>(128)).additions == 12);
  CHECK(sum_pairwise<Counted>(std::vector<Counted>(1 << 20)).additions == 25);
}
// [pairwise_roundings]

// [sum_verdicts]
TEST_CASE("each way to add holds or fails as the table says", "[sums]")
{
  const std::vector<std::string> methods = names_of(sum_methods<float>());
  check_verdicts(
      sum_verdicts<float>(), methods,
      {{"1 to 100", methods},
       {"2^24 and 1000 ones", {"pairwise", "wider", "Kahan", "compensated"}},
       {"an hour of 1/60 s", {"pairwise", "wider", "Kahan", "compensated"}},
       {"1, 1e30, 1, −1e30", {"Eigen", "pairwise", "compensated"}},
       {"largest, 0, largest, −largest", {"wider", "compensated"}}});
  check_verdicts(
      sum_verdicts<double>(), methods,
      {{"1 and 4096 times 2^-53", {"pairwise", "Kahan", "compensated"}},
       {"1, 1e100, 1, −1e100", {"Eigen", "pairwise", "compensated"}},
       {"1, 1e100, −1e100, 1", {"compensated"}},
       {"1e200, 1e100, 1, −1e200, −1e100", {}}});
}
// [sum_verdicts]

TEST_CASE("the right sums of the table are the exact ones, rounded", "[sums]")
{
  const auto check = []<class Real>(Real)
  {
    for (const SumCase<Real>& one : sum_cases(Real()))
    {
      INFO(one.what);
      const Whole off = abs(whole(one.right) - exact_sum(one.numbers).sum);
      CHECK(off <= whole(ulp(one.right / 2)));
    }
  };
  check(0.0f);
  check(0.0);
}

TEST_CASE("a sum 3 ulp off is 3 ulp off, and one that is no number infinitely", "[sums]")
{
  CHECK(sum_error(1 + 3 * 0x1p-23f, 1.0f) == 3);
  CHECK(std::isinf(sum_error(std::numeric_limits<float>::infinity(), 1.0f)));
}

// [ones]
TEST_CASE("a hundred million ones in float stop at 16,777,216, a running sum does not", "[sums]")
{
  float naive = 0;
  RunningSum<float> running;
  for (int i = 0; i < 100000000; ++i)
  {
    naive += 1;
    running.add(1);
  }
  CHECK(naive == 16777216);
  CHECK(running.sum == 100000000);
}
// [ones]

// [accumulate]
TEST_CASE("std::accumulate adds as the naive loop does, bit for bit", "[sums]")
{
  WholeRange<float> draw;
  const std::vector<float> numbers = shares(draw, 10000, false);
  CHECK(std::accumulate(numbers.begin(), numbers.end(), 0.0f) == sum_naive<float>(numbers));
}
// [accumulate]

// [bounds]
TEMPLATE_TEST_CASE(
    "every way to add keeps its bound, for 1 to 3000 numbers", "[sums]", float, double)
{
  WholeRange<TestType> draw;
  for (int round = 0; round < 100; ++round)
  {
    const int n = draw.drawn(1, 3000);
    const std::vector<TestType> numbers = shares(draw, n, round % 2 == 0);
    const ExactSum exact = exact_sum(numbers);
    const int roundings = most_roundings(n);
    CHECK(is_within(sum_naive<TestType>(numbers), exact, n - 1));
    CHECK(is_within(sum_eigen(std::span<const TestType>(numbers)), exact, n - 1));
    CHECK(is_within(sum_pairwise<TestType>(numbers), exact, roundings));
    CHECK(is_within(sum_wide<TestType>(numbers), exact, sizeof(TestType) == 4 ? 1 : n - 1));
    CHECK(is_within(sum_kahan<TestType>(numbers), exact, 3));
    CHECK(is_compensated(sum_compensated<TestType>(numbers), exact, 4 * (n + 32)));
  }
}
// [bounds]

// [any_size]
TEMPLATE_TEST_CASE(
    "100,000 numbers of any size, 1 to 40 at a time, add up within u|sum| + 4(n + 32)u² of their "
    "sizes",
    "[sums]", float, double)
{
  using Limits = std::numeric_limits<TestType>;
  WholeRange<TestType> draw;
  int wrong = 0, endless = 0;
  for (int total = 0; total < 100000;)
  {
    const int n = draw.drawn(1, 40);
    total += n;
    std::vector<TestType> numbers;
    for (int i = 0; i < n; ++i)
    {
      // Every other list has numbers of one size, which cancel.
      const bool undo = i > 0 && draw.drawn(0, 2) == 0;
      numbers.push_back(
          undo ? -numbers[static_cast<std::size_t>(draw.drawn(0, i - 1))] : draw.number());
    }
    const ExactSum exact = exact_sum(numbers);
    const TestType answer = sum_compensated<TestType>(numbers);
    endless += std::isinf(answer) ? 1 : 0;
    wrong += std::isnan(answer) ? 1 : 0;
    if (std::isfinite(answer))
    {
      wrong += is_compensated(answer, exact, 4 * (n + 32)) ? 0 : 1;
    }
    else
    {
      wrong += abs(exact.sum) + whole(ulp(Limits::max() / 2)) > whole(Limits::max()) ? 0 : 1;
      wrong += (answer > 0) == (exact.sum > 0) ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  CHECK(endless > 0);
}
// [any_size]

TEMPLATE_TEST_CASE("no numbers add up to 0; infinite and NaN come through", "[sums]", float, double)
{
  const TestType infinite = std::numeric_limits<TestType>::infinity(), none = infinite - infinite;
  const std::vector<TestType> nothing, one{3}, endless{1, infinite}, both{infinite, -infinite},
      unknown{1, none, infinite};
  for (const SumMethod<TestType>& method : sum_methods<TestType>())
  {
    INFO(method.name);
    CHECK(method.sum(nothing) == 0);
    CHECK(method.sum(one) == 3);
  }
  CHECK(sum_compensated<TestType>(endless) == infinite);
  CHECK(std::isnan(sum_compensated<TestType>(both)));
  CHECK(std::isnan(sum_compensated<TestType>(unknown)));
}

// [overflow]
TEMPLATE_TEST_CASE(
    "a thousand largest numbers, then a thousand negative ones and 3 quarters, add up to those",
    "[sums]", float, double)
{
  const TestType most = std::numeric_limits<TestType>::max();
  std::vector<TestType> numbers(2001, most);
  std::fill(numbers.begin() + 1000, numbers.end(), -most);
  numbers[2000] = most / 4 * 3;
  CHECK(sum_compensated<TestType>(numbers) == most / 4 * 3);
}
// [overflow]

TEST_CASE("whole numbers add up exactly, pairwise, however many there are", "[sums]")
{
  for (int n = 0; n <= 1000; ++n)
  {
    std::vector<float> numbers;
    for (int i = 1; i <= n; ++i)
    {
      numbers.push_back(static_cast<float>(i));
    }
    const float right = static_cast<float>(n * (n + 1) / 2);
    REQUIRE(sum_pairwise<float>(numbers) == right);
    REQUIRE(sum_compensated<float>(numbers) == right);
  }
}

TEST_CASE("a running sum finds what is lost, whichever number is larger", "[sums]")
{
  RunningSum<double> sum;
  for (const double x : {1.0, 1e100, 1.0, -1e100})
  {
    sum.add(x);
  }
  CHECK(sum.sum == 2);
  CHECK(sum.lost == 0);
}
