/// \file
/// \brief Rows of plain numbers, in registers, and of packs do the same.

#include "common/simd/pack.hpp"
#include "common/simd/row.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>
#include <type_traits>

using namespace cookbook;

namespace
{

using Lanes = Pack<float, 4>;

#define ROWS_OF_ONE                                                                                \
  (RowOf<float, 3>), (RowOf<double, 3>), (RowOf<float, 3, Pack<float, 4>>),                        \
      (RowOf<double, 3, Pack<double, 2>>)
#define ROWS ROWS_OF_ONE, (RowOf<Lanes, 3>), (RowOf<Pack<double, 4>, 3>)

/// How many pairs a number belongs to.
template <class Number>
constexpr int pairs = std::is_arithmetic_v<Number> ? 1 : 4;

/// A number made of that of each pair.
template <class Number, class OfPair>
Number number(const OfPair& of_pair)
{
  using Real = typename PartOf<Number>::type;
  if constexpr (pairs<Number> == 1)
  {
    return static_cast<Real>(of_pair(0));
  }
  else
  {
    std::array<Real, 4> numbers;
    for (std::size_t k = 0; k < 4; ++k)
    {
      numbers[k] = static_cast<Real>(of_pair(static_cast<int>(k)));
    }
    return load_pack<Number>(numbers.data());
  }
}

/// That of pair k.
template <class Number>
auto of_pair(const Number& number, int k)
{
  if constexpr (pairs<Number> == 1)
  {
    return number;
  }
  else
  {
    return number[k];
  }
}

/// Number i of pair k.
template <class Row>
double at(const Row& row, int i, int k)
{
  return static_cast<double>(of_pair(row[i], k));
}

/// A row whose numbers differ from pair to pair, of both signs.
template <class Row>
Row numbers_from(double first)
{
  using Number = typename Row::Number;
  return {
      number<Number>([&](int k) { return first + k; }),
      number<Number>([&](int k) { return 1.5 - 2 * (first + k); }),
      number<Number>([&](int k) { return (first + k) * (first + k) - 3; })};
}

/// Whether number i of a row is what a function gives of the numbers i of two others, for all i.
template <class Row, class Function>
bool is(const Row& result, const Row& a, const Row& b, const Function& function)
{
  bool same = true;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < pairs<typename Row::Number>; ++k)
    {
      same = same && of_pair(result[i], k) == function(of_pair(a[i], k), of_pair(b[i], k));
    }
  }
  return same;
}

/// A row of −1 where a bit is set, 1 elsewhere.
template <class Row>
Row minus_where(unsigned bits)
{
  const auto sign = [&](int i) { return typename Row::Number(bits >> i & 1 ? -1.0f : 1.0f); };
  if constexpr (std::is_same_v<Row, typename Row::Four>)
  {
    return {sign(0), sign(1), sign(2), sign(3)};
  }
  else
  {
    return {sign(0), sign(1), sign(2)};
  }
}

} // namespace

TEMPLATE_TEST_CASE("arithmetic on rows is that on their numbers", "[row]", ROWS)
{
  using Row = TestType;
  const Row a = numbers_from<Row>(0.5), b = numbers_from<Row>(-2.25);
  const Row half(typename Row::Number(0.5f));
  CHECK(is(a + b, a, b, [](auto x, auto y) { return x + y; }));
  CHECK(is(a - b, a, b, [](auto x, auto y) { return x - y; }));
  CHECK(is(a * b, a, b, [](auto x, auto y) { return x * y; }));
  CHECK(is(a / b, a, b, [](auto x, auto y) { return x / y; }));
  CHECK(is(abs(a), a, b, [](auto x, auto) { return std::abs(x); }));
  CHECK(is(min(a, b), a, b, [](auto x, auto y) { return std::min(x, y); }));
  CHECK(is(max(a, b), a, b, [](auto x, auto y) { return std::max(x, y); }));
  CHECK(is(a * half, a, b, [](auto x, auto) { return x / 2; }));
  CHECK(is(select(a < b, a, half), a, b, [](auto x, auto y) { return x < y ? x : x / x / 2; }));
  CHECK(is(select(a <= a, b, a), a, b, [](auto, auto y) { return y; }));
}

TEMPLATE_TEST_CASE("a row has its numbers in order, and turns them", "[row]", ROWS)
{
  using Row = TestType;
  using Number = typename Row::Number;
  const Row three(Number(1), Number(2), Number(3));
  const typename Row::Four four(Number(1), Number(2), Number(3), Number(4));
  for (int i = 0; i < 4; ++i)
  {
    const int last = pairs<Number> - 1;
    CHECK(at(four, i, last) == i + 1);
    if (i < 3)
    {
      CHECK(at(three, i, last) == i + 1);
      CHECK(at(turned_once(three), i, last) == (i + 1) % 3 + 1);
      CHECK(at(turned_twice(three), i, last) == (i + 2) % 3 + 1);
    }
  }
}

TEMPLATE_TEST_CASE("three or four rows become columns", "[row]", ROWS)
{
  using Row = TestType;
  using Number = typename Row::Number;
  Row three[3];
  typename Row::Four four[4];
  for (int i = 0; i < 4; ++i)
  {
    const auto at = [&](int j)
    { return number<Number>([&](int k) { return 4 * i + j + 16 * k; }); };
    four[i] = {at(0), at(1), at(2), at(3)};
    three[i % 3] = i < 3 ? Row(at(0), at(1), at(2)) : three[0];
  }
  transpose(three);
  transpose(four);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      for (int k = 0; k < pairs<Number>; ++k)
      {
        CHECK(at(four[i], j, k) == 4 * j + i + 16 * k);
        CHECK(at(three[i % 3], j % 3, k) == 4 * (j % 3) + i % 3 + 16 * k);
      }
    }
  }
}

TEMPLATE_TEST_CASE("any and all numbers of a mask, and each by its bit", "[row]", ROWS)
{
  using Row = TestType;
  const typename Row::Number zero(0.0f);
  for (unsigned set = 0; set < 16; ++set)
  {
    CAPTURE(set);
    const Row three = minus_where<Row>(set & 7);
    CHECK(any((three < Row(zero)).any()) == ((set & 7) != 0));
    CHECK(any((three <= Row(zero)).all()) == ((set & 7) == 7));
    CHECK(any(((three < Row(zero)) | (Row(zero) <= three)).all()));
    CHECK_FALSE(any(((three < Row(zero)) & (Row(zero) < Row(zero))).any()));
    if constexpr (pairs<typename Row::Number> == 1)
    {
      using Four = typename Row::Four;
      CHECK((minus_where<Four>(set) < Four(zero)).bits() == set);
    }
  }
}

TEMPLATE_TEST_CASE("the first place at which masks are set", "[row]", ROWS)
{
  using Row = TestType;
  using Number = typename Row::Number;
  for (int place = 0; place < 6; ++place)
  {
    // All places from this one on are set; of the second pair of boxes the last only.
    const auto sign = [&](int i)
    { return number<Number>([&](int k) { return i < (k == 1 ? 5 : place) ? 1 : -1; }); };
    const Row zero(Number(0.0f));
    const Row low(sign(0), sign(1), sign(2)), high(sign(3), sign(4), sign(5));
    const auto first = first_set({low < zero, high < zero});
    CHECK(static_cast<int>(of_pair(first, 0)) == place);
    if constexpr (pairs < Number >> 1)
    {
      CHECK(first[1] == 5);
    }
  }
}

TEST_CASE("the number that is meant differs from pair to pair", "[row]")
{
  const int meant[] = {2, 0, 1, 2};
  const Which<Lanes> lane = which(number<Lanes>([&](int k) { return meant[k]; }));
  const RowOf<Lanes, 3> numbers = numbers_from<RowOf<Lanes, 3>>(0.5);
  for (int k = 0; k < 4; ++k)
  {
    CHECK(chosen(numbers, lane)[k] == numbers[meant[k]][k]);
    CHECK(chosen(numbers, next(lane))[k] == numbers[next(meant[k])][k]);
    CHECK(chosen(numbers, next(next(lane)))[k] == numbers[(meant[k] + 2) % 3][k]);
  }
  for (int i = 0; i < 3; ++i)
  {
    CHECK(chosen(RowOf<double, 3>(3, 4, 5), which(i)) == 3 + i);
    CHECK(next(i) == (i + 1) % 3);
  }
}
