/// \file
/// \brief Groups of one pair, groups with a pair in every lane, and registers do the same.

#include "common/simd/registers.hpp"

#include "tests/catch.hpp"

#include <array>
#include <cmath>

using namespace cookbook;

namespace
{

constexpr std::size_t width = 4;
using Lanes = Pack<float, width>;
using Plain = Group<float, 3>;
using Many = Group<Lanes, 3>;

/// What pair number k holds: its three numbers, all different from pair to pair, of both signs.
template <class Real>
std::array<Real, 3> numbers_of(std::size_t k, Real shift)
{
  const Real first = shift + static_cast<Real>(k);
  return {first, Real(1.5) - 2 * first, first * first - 3};
}

template <class Real>
Group<Real, 3> plain(std::size_t k, Real shift)
{
  const auto [x, y, z] = numbers_of(k, shift);
  return group<Real>(x, y, z);
}

template <class Real>
Group<Pack<Real, width>, 3> many(Real shift)
{
  std::array<std::array<Real, width>, 3> rows;
  for (std::size_t k = 0; k < width; ++k)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      rows[i][k] = numbers_of(k, shift)[i];
    }
  }
  using Row = Pack<Real, width>;
  return group<Row>(
      load_pack<Row>(rows[0].data()), load_pack<Row>(rows[1].data()),
      load_pack<Row>(rows[2].data()));
}

/// Whether lane k of a group of packs holds what the group of one pair holds.
template <class OfMany, class OfOne>
void check_same(const OfMany& of_many, std::size_t k, const OfOne& of_one)
{
  for (int i = 0; i < 3; ++i)
  {
    CAPTURE(k, i);
    CHECK(of_many[i][k] == of_one[i]);
  }
}

} // namespace

TEMPLATE_TEST_CASE(
    "arithmetic on a group of packs is that on the group of each pair", "[group]", float, double)
{
  using Real = TestType;
  using OfOne = Group<Real, 3>;
  const auto a = many<Real>(0.5f), b = many<Real>(-2.25f);
  const Group<Pack<Real, width>, 3> half(Pack<Real, width>(0.5f));
  for (std::size_t k = 0; k < width; ++k)
  {
    const OfOne x = plain<Real>(k, 0.5f), y = plain<Real>(k, -2.25f), x_half(Real(0.5f));
    check_same(a + b, k, x + y);
    check_same(a - b, k, x - y);
    check_same(a * b, k, x * y);
    check_same(a / b, k, x / y);
    check_same(abs(a), k, abs(x));
    check_same(min(a, b), k, min(x, y));
    check_same(max(a, b), k, max(x, y));
    check_same(a * half, k, x * x_half);
    check_same(select(a < b, a, half), k, select(x < y, x, x_half));
    check_same(select(a <= b, half, a), k, select(x <= y, x_half, x));
    check_same(turned_once(a), k, turned_once(x));
    check_same(turned_twice(a), k, turned_twice(x));
  }
}

TEMPLATE_TEST_CASE(
    "a row in registers has its numbers in order, and the third again", "[group]", float, double)
{
  using Rows = RowTraits<Registers<TestType>>;
  const Registers<TestType> three = Rows::three(1, 2, 3), four = Rows::four(1, 2, 3, 4);
  const auto check = [](const auto& numbers, const std::array<TestType, 4>& right)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      CHECK(numbers[i] == right[i]);
    }
  };
  check(three, {1, 2, 3, 3});
  check(turned_once(three), {2, 3, 1, 1});
  check(turned_twice(three), {3, 1, 2, 2});
  check(four, {1, 2, 3, 4});
  check(max(four, Rows::four(4, 3, 2, 1)), {4, 3, 3, 4});
  check(min(four, Rows::four(4, 3, 2, 1)), {1, 2, 2, 1});
  check(-four, {-1, -2, -3, -4});
}

TEMPLATE_TEST_CASE(
    "each of four numbers has its bit in a mask", "[group]", (Group<float, 3>), (Group<double, 3>),
    Registers<float>, Registers<double>)
{
  using Rows = RowTraits<TestType>;
  using Real = RowNumber<TestType>;
  using Four = FourOf<TestType>;
  for (unsigned set = 0; set < 16; ++set)
  {
    const auto at = [&](unsigned i) { return Real((set >> i & 1) != 0 ? -1 : 1); };
    const Four numbers = Rows::four(at(0), at(1), at(2), at(3));
    const Four zero(Real(0)), one(Real(1));
    CHECK(Rows::bits(numbers < zero) == set);
    CHECK(Rows::bits((numbers <= one) & (numbers < zero)) == set);
    CHECK(Rows::bits((one < zero) | (numbers < zero)) == set);
    for (unsigned i = 0; i < 4; ++i)
    {
      CHECK(select(numbers < zero, one, zero)[static_cast<int>(i)] == (at(i) < 0 ? 1 : 0));
    }
  }
}

TEMPLATE_TEST_CASE(
    "four rows become columns", "[group]", (Group<float, 3>), (Group<double, 3>), Registers<float>,
    Registers<double>)
{
  using Real = RowNumber<TestType>;
  FourOf<TestType> square[4];
  for (int i = 0; i < 4; ++i)
  {
    const Real first = Real(4 * i);
    square[i] = RowTraits<TestType>::four(first, first + 1, first + 2, first + 3);
  }
  transpose(square);
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      CHECK(square[i][j] == Real(4 * j + i));
    }
  }
}

TEMPLATE_TEST_CASE(
    "three rows become columns", "[group]", (Group<float, 3>), (Group<double, 3>), Registers<float>,
    Registers<double>)
{
  using Real = RowNumber<TestType>;
  TestType rows[3];
  for (int i = 0; i < 3; ++i)
  {
    rows[i] = RowTraits<TestType>::three(Real(3 * i), Real(3 * i + 1), Real(3 * i + 2));
  }
  transpose(rows);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      CHECK(rows[i][j] == Real(3 * j + i));
    }
  }
}

TEMPLATE_TEST_CASE("rows become columns, of one pair and of many", "[group]", float, double)
{
  using Real = TestType;
  Group<Real, 3> rows[] = {plain<Real>(0, 1), plain<Real>(1, 1), plain<Real>(2, 1)};
  // Of pair k: numbers of 1 + k, 2 + k, 3 + k.
  Group<Pack<Real, width>, 3> many_rows[] = {many<Real>(1), many<Real>(2), many<Real>(3)};
  transpose(rows);
  transpose(many_rows);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      CHECK(rows[i][static_cast<int>(j)] == numbers_of<Real>(j, 1)[i]);
      CHECK(many_rows[i][static_cast<int>(j)][0] == numbers_of<Real>(j, 1)[i]);
      CHECK(many_rows[i][static_cast<int>(j)][3] == numbers_of<Real>(j, 4)[i]);
    }
  }
}

TEST_CASE("the lane that is meant differs from pair to pair", "[group]")
{
  const std::array<float, width> meant{2, 0, 1, 2};
  const Which<Lanes> lane = which(load_pack<Lanes>(meant.data()));
  const Many a = many(0.5f);
  for (std::size_t k = 0; k < width; ++k)
  {
    const Plain x = plain(k, 0.5f);
    const int i = static_cast<int>(meant[k]);
    CHECK(chosen(a, lane)[k] == chosen(x, i));
    CHECK(chosen(a, next(lane))[k] == chosen(x, next(i)));
    CHECK(chosen(a, next(next(lane)))[k] == chosen(x, next(next(i))));
  }
  for (int i = 0; i < 3; ++i)
  {
    CHECK(chosen(group<double>(3, 4, 5), i) == 3 + i);
  }
  CHECK(next(0) == 1);
  CHECK(next(1) == 2);
  CHECK(next(2) == 0);
  CHECK(which(2) == 2);
}

TEST_CASE("nine places are three times three", "[group]")
{
  for (int place = 0; place < 9; ++place)
  {
    CHECK(third(place) == place / 3);
    CHECK(third(Lanes(static_cast<float>(place)))[2] == static_cast<float>(place / 3));
  }
}

TEMPLATE_TEST_CASE(
    "the first place at which masks are set", "[group]", (Group<float, 3>), Registers<float>)
{
  using Rows = RowTraits<TestType>;
  for (int place = 0; place < 6; ++place)
  {
    CAPTURE(place);
    // All places from this one on are set; the second pair of boxes has the last only.
    const auto at = [&](int i, int from) { return i < from ? 1.0f : -1.0f; };
    const TestType zero(0.0f);
    const TestType low = Rows::three(at(0, place), at(1, place), at(2, place));
    const TestType high = Rows::three(at(3, place), at(4, place), at(5, place));
    CHECK(Rows::first_set({low < zero, high < zero}) == place);
    const auto lanes = [&](int i) -> Lanes
    {
      const std::array<float, width> numbers{at(i, place), at(i, 5), at(i, place), at(i, place)};
      return load_pack<Lanes>(numbers.data());
    };
    const Many many_low = group<Lanes>(lanes(0), lanes(1), lanes(2));
    const Many many_high = group<Lanes>(lanes(3), lanes(4), lanes(5));
    const Many many_zero(Lanes(0.0f));
    const Lanes first = RowTraits<Many>::first_set({many_low < many_zero, many_high < many_zero});
    CHECK(first[0] == static_cast<float>(place));
    CHECK(first[1] == 5);
  }
}

TEMPLATE_TEST_CASE("any and all numbers of a mask", "[group]", (Group<float, 3>), Registers<float>)
{
  using Rows = RowTraits<TestType>;
  using OfMany = RowTraits<Many>;
  for (unsigned set = 0; set < 8; ++set)
  {
    CAPTURE(set);
    const auto at = [&](unsigned i) { return (set >> i & 1) != 0 ? -1.0f : 1.0f; };
    const auto of_one = Rows::three(at(0), at(1), at(2)) < TestType(0.0f);
    CHECK(Rows::any(of_one) == (set != 0));
    CHECK(Rows::all(of_one) == (set == 7));
    const Many numbers = group<Lanes>(Lanes(at(0)), Lanes(at(1)), Lanes(at(2)));
    const Many zero(Lanes(0.0f));
    const auto mask = numbers < zero;
    CHECK(any(OfMany::any(mask)) == (set != 0));
    CHECK(all(OfMany::all(mask)) == (set == 7));
    CHECK(any(OfMany::all(mask)) == (set == 7));
    CHECK(all(OfMany::any(mask | (zero < zero))) == (set != 0));
    CHECK_FALSE(any(OfMany::any(mask & (zero < zero))));
  }
}
