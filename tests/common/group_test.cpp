/// \file
/// \brief Groups of one pair and groups with a pair in every lane do the same.

#include "common/math/choose.hpp"

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
std::array<float, 3> numbers_of(std::size_t k, float shift)
{
  const float first = shift + static_cast<float>(k);
  return {first, 1.5f - 2 * first, first * first - 3};
}

Plain plain(std::size_t k, float shift)
{
  const auto [x, y, z] = numbers_of(k, shift);
  return group<float>(x, y, z);
}

Many many(float shift)
{
  std::array<std::array<float, width>, 3> rows;
  for (std::size_t k = 0; k < width; ++k)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      rows[i][k] = numbers_of(k, shift)[i];
    }
  }
  return group<Lanes>(
      load_pack<Lanes>(rows[0].data()), load_pack<Lanes>(rows[1].data()),
      load_pack<Lanes>(rows[2].data()));
}

/// Whether lane k of a group of packs holds what the group of one pair holds.
void check_same(const Many& of_many, std::size_t k, const Plain& of_one)
{
  for (int i = 0; i < 3; ++i)
  {
    CAPTURE(k, i);
    CHECK(of_many[i][k] == of_one[i]);
  }
}

} // namespace

TEST_CASE("arithmetic on a group of packs is that on the group of each pair", "[group]")
{
  const Many a = many(0.5f), b = many(-2.25f);
  const Many half(Lanes(0.5f));
  for (std::size_t k = 0; k < width; ++k)
  {
    const Plain x = plain(k, 0.5f), y = plain(k, -2.25f);
    check_same(a + b, k, x + y);
    check_same(a - b, k, x - y);
    check_same(a * b, k, x * y);
    check_same(a / b, k, x / y);
    check_same(-a, k, -x);
    check_same(abs(a), k, abs(x));
    check_same(min(a, b), k, min(x, y));
    check_same(max(a, b), k, max(x, y));
    check_same(a * half, k, x * Plain(0.5f));
    check_same(select(a < b, a, half), k, select(x < y, x, Plain(0.5f)));
    check_same(select(a <= b, half, a), k, select(x <= y, Plain(0.5f), x));
    check_same(turned_once(a), k, turned_once(x));
    check_same(turned_twice(a), k, turned_twice(x));
  }
}

TEST_CASE("a group of one pair has its numbers in order, and the third again", "[group]")
{
  const Plain three = group<float>(1, 2, 3);
  CHECK(three[0] == 1);
  CHECK(three[1] == 2);
  CHECK(three[2] == 3);
  CHECK(three[3] == 3);
  CHECK(turned_once(three)[0] == 2);
  CHECK(turned_once(three)[2] == 1);
  CHECK(turned_twice(three)[0] == 3);
  CHECK(turned_twice(three)[1] == 1);
  const Group<float, 4> four = group<float>(1, 2, 3, 4);
  CHECK(four[3] == 4);
  CHECK(last_three(four)[0] == 2);
  CHECK(last_three(four)[2] == 4);
}

TEST_CASE("rows become columns, of one pair and of many", "[group]")
{
  Plain rows[] = {plain(0, 1), plain(1, 1), plain(2, 1)};
  Many many_rows[] = {many(1), many(2), many(3)}; // of pair k: numbers of 1 + k, 2 + k, 3 + k
  transpose(rows);
  transpose(many_rows);
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      CHECK(rows[i][j] == numbers_of(j, 1)[i]);
      CHECK(many_rows[i][static_cast<int>(j)][0] == numbers_of(j, 1)[i]);
      CHECK(many_rows[i][static_cast<int>(j)][3] == numbers_of(j, 4)[i]);
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

TEST_CASE("the first place at which masks are set", "[group]")
{
  for (int place = 0; place < 6; ++place)
  {
    CAPTURE(place);
    // All places from this one on are set; the second pair has the last only.
    const auto at = [&](int i, int from) { return i < from ? 1.0f : -1.0f; };
    const Plain zero(0.0f);
    const Plain low = group<float>(at(0, place), at(1, place), at(2, place));
    const Plain high = group<float>(at(3, place), at(4, place), at(5, place));
    CHECK(first_set<float>({low < zero, high < zero}) == place);
    const auto lanes = [&](int i) -> Lanes
    {
      const std::array<float, width> numbers{at(i, place), at(i, 5), at(i, place), at(i, place)};
      return load_pack<Lanes>(numbers.data());
    };
    const Many many_low = group<Lanes>(lanes(0), lanes(1), lanes(2));
    const Many many_high = group<Lanes>(lanes(3), lanes(4), lanes(5));
    const Many many_zero(Lanes(0.0f));
    const Lanes first = first_set<Lanes>({many_low < many_zero, many_high < many_zero});
    CHECK(first[0] == static_cast<float>(place));
    CHECK(first[1] == 5);
  }
}

TEST_CASE("any and all lanes of a mask", "[group]")
{
  for (unsigned set = 0; set < 8; ++set)
  {
    CAPTURE(set);
    const auto at = [&](unsigned i) { return (set >> i & 1) != 0 ? -1.0f : 1.0f; };
    CHECK(any_lane<float>(group<float>(at(0), at(1), at(2)) < Plain(0.0f)) == (set != 0));
    const Many numbers = group<Lanes>(Lanes(at(0)), Lanes(at(1)), Lanes(at(2)));
    const Many zero(Lanes(0.0f));
    const auto mask = numbers < zero;
    CHECK(any(any_lane<Lanes>(mask)) == (set != 0));
    CHECK(all(all_lanes<Lanes>(mask)) == (set == 7));
    CHECK(any(all_lanes<Lanes>(mask)) == (set == 7));
    CHECK(all(any_lane<Lanes>(mask | (zero < zero))) == (set != 0));
    CHECK_FALSE(any(any_lane<Lanes>(mask & (zero < zero))));
  }
}
