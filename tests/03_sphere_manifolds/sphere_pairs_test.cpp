/// \file
/// \brief What holds for many pairs at once: the same answers as one by one, to the last bit.

#include "03_sphere_manifolds/sphere_pairs/sphere_pairs.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>

using namespace cookbook;

namespace
{

using Pair = std::pair<Sphere<float>, Sphere<float>>;

/// The same numbers on every machine, in [low, high).
class Random
{
public:
  float operator()(float low, float high)
  {
    return low + (high - low) * static_cast<float>(engine_() >> 8) * 0x1p-24f;
  }

private:
  std::mt19937 engine_{3};
};

/// Pairs of which about half touch, `scale` [m] large.
std::vector<Pair> random_pairs(std::size_t count, float scale = 1)
{
  Random random;
  const auto sphere = [&]
  {
    return Sphere<float>{
        {scale * random(-1, 1), scale * random(-1, 1), scale * random(-1, 1)},
        scale * random(0.1f, 1)};
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i)
  {
    pairs.push_back({sphere(), sphere()});
  }
  return pairs;
}

/// Concentric, nearly so, without size, too small and too large to be squared or even added.
std::vector<Pair> degenerate_pairs()
{
  return {
      {{{0, 0, 0}, 1}, {{0, 0, 0}, 1}},
      {{{0, 0, 0}, 1}, {{0, 0, 0}, 3}},
      {{{5, 6, 7}, 0}, {{5, 6, 7}, 0}},
      {{{0, 0, 0}, 1}, {{1e-23f, 0, 0}, 1}},
      {{{0, 0, 0}, 1}, {{0, 1e-45f, 0}, 1}},
      {{{0, 0, 0}, 1e-30f}, {{0, 0, 1e-30f}, 1e-30f}},
      {{{0, 0, 0}, 3e38f}, {{3e38f, 0, 0}, 3e38f}},
      {{{-3e38f, 0, 0}, 3e38f}, {{3e38f, 0, 0}, 3e38f}},
      {{{-3e38f, 0, 0}, 1}, {{3e38f, 0, 0}, 1}},
      {{{-3e38f, -3e38f, -3e38f}, 3e38f}, {{3e38f, 3e38f, 3e38f}, 3e38f}},
      {{{0, 0, 0}, 3e38f}, {{1, 0, 0}, 3e38f}},
      {{{0, 0, 0}, 3e38f}, {{0, 0, 0}, 3e38f}},
      {{{1e20f, 0, 0}, 1}, {{-1e20f, 0, 0}, 1}},
      {{{0, 0, 0}, 1}, {{2, 0, 0}, 1}},
      {{{0, 0, 0}, 1}, {{3, 4, 0}, 4}}};
}

bool same_bits(float x, float y)
{
  return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
}

/// How many of the batch's answers differ from `sphere_sphere` in any bit.
int differences(const std::vector<Pair>& pairs, InstructionSet set)
{
  const Lists in = lists_of_pairs(pairs);
  Lists out = lists_of_overlaps(pairs.size());
  sphere_pairs(pairs_of(in), overlaps_of(out), set);
  int count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const auto one = sphere_sphere(pairs[i].first, pairs[i].second);
    bool same = one.has_value() == (out[3][i] >= 0);
    if (one)
    {
      const Vector3<float>& position = one->points[0].position;
      const std::array<float, 7> expected{one->normal.x(), one->normal.y(), one->normal.z(),
                                          one->depth,      position.x(),    position.y(),
                                          position.z()};
      for (std::size_t k = 0; k < 7; ++k)
      {
        same = same && same_bits(out[k][i], expected[k]);
      }
    }
    count += same ? 0 : 1;
  }
  return count;
}

} // namespace

// [equal]
TEST_CASE("100,000 random pairs at once have the bits of one by one", "[sphere_pairs][S1][S2][S4]")
{
  for (const InstructionSet set : instruction_sets())
  {
    CHECK(differences(random_pairs(100'000), set) == 0);
  }
}

TEST_CASE("pairs too small and too large to square have the bits of one by one", "[sphere_pairs]")
{
  for (const InstructionSet set : instruction_sets())
  {
    for (const float scale : {1e-40f, 1e-30f, 1e-12f, 1e6f, 1e19f, 1e30f, 3e38f})
    {
      CHECK(differences(random_pairs(1'000, scale), set) == 0);
    }
  }
}
// [equal]

TEST_CASE("every degenerate pair, in every lane, has the bits of one by one", "[sphere_pairs]")
{
  const std::vector<Pair> ordinary = random_pairs(48);
  for (const InstructionSet set : instruction_sets())
  {
    CHECK(differences(degenerate_pairs(), set) == 0);
    for (const Pair& degenerate : degenerate_pairs())
    {
      for (std::size_t lane = 0; lane < 48; ++lane)
      {
        std::vector<Pair> pairs = ordinary;
        pairs[lane] = degenerate;
        REQUIRE(differences(pairs, set) == 0);
      }
    }
  }
}

TEST_CASE("finite pairs never give NaN", "[sphere_pairs]")
{
  std::vector<Pair> pairs = degenerate_pairs();
  for (const float scale : {1e-45f, 1e-23f, 1.0f, 1e23f, 3e38f})
  {
    const std::vector<Pair> more = random_pairs(2'000, scale);
    pairs.insert(pairs.end(), more.begin(), more.end());
  }
  const Lists in = lists_of_pairs(pairs);
  for (const InstructionSet set : instruction_sets())
  {
    Lists out = lists_of_overlaps(pairs.size());
    sphere_pairs(pairs_of(in), overlaps_of(out), set);
    int unknown = 0;
    for (std::size_t k = 0; k < 7; ++k)
    {
      for (const float number : out[k])
      {
        unknown += std::isnan(number) ? 1 : 0;
      }
    }
    CHECK(unknown == 0);
  }
}

TEST_CASE(
    "instruction sets are portable, AVX2 and AVX-512, the first of them everywhere",
    "[sphere_pairs]")
{
  const std::vector<std::string> names{"portable", "AVX2", "AVX-512"};
  const std::vector<InstructionSet> sets = instruction_sets();
  REQUIRE((!sets.empty() && sets.size() <= names.size()));
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    CHECK(name_of(sets[i]) == names[i]);
  }
}

TEST_CASE("0 to 17 pairs are answered, and nothing beside them is written", "[sphere_pairs]")
{
  const std::vector<Pair> pairs = random_pairs(17);
  const Lists in = lists_of_pairs(pairs);
  for (const InstructionSet set : instruction_sets())
  {
    for (std::size_t count = 0; count <= 17; ++count)
    {
      const std::vector<Pair> some(
          pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count));
      CHECK(differences(some, set) == 0);

      Lists out = lists_of_overlaps(19);
      std::fill(out[3].begin(), out[3].end(), -99.0f);
      const auto part = [&](const auto list) { return list.subspan(1, count); };
      const SphereOverlaps o{part(out[0]), part(out[1]), part(out[2]), part(out[3]),
                             part(out[4]), part(out[5]), part(out[6])};
      const auto first = [&](std::size_t k) { return in[k].first(count); };
      sphere_pairs(
          {first(0), first(1), first(2), first(3), first(4), first(5), first(6), first(7)}, o, set);
      CHECK(out[3][0] == -99);
      CHECK(out[3][count + 1] == -99);
    }
  }
}

TEST_CASE("a pair without a safe square writes nothing beside its block either", "[sphere_pairs]")
{
  std::vector<Pair> pairs = random_pairs(48);
  pairs[3] = {{{1, 2, 3}, 1}, {{1, 2, 3}, 1}}; // concentric
  const Lists in = lists_of_pairs(pairs);
  for (const InstructionSet set : instruction_sets())
  {
    Lists out = lists_of_overlaps(48);
    std::fill(out[3].begin(), out[3].end(), -99.0f);
    const auto first = [&](std::size_t k) { return in[k].first(16); };
    const auto to = [&](std::size_t k) { return out[k].first(16); };
    sphere_pairs(
        {first(0), first(1), first(2), first(3), first(4), first(5), first(6), first(7)},
        {to(0), to(1), to(2), to(3), to(4), to(5), to(6)}, set);
    CHECK(out[3][3] == 2);
    CHECK(std::count(out[3].begin() + 16, out[3].end(), -99.0f) == 32);
  }
}

TEST_CASE("lists that begin anywhere, and long ones that are streamed, agree", "[sphere_pairs]")
{
  constexpr std::size_t count = 70'001; // more than the streams' least, and no whole block
  const Lists in = lists_of_pairs(random_pairs(count));
  Lists whole = lists_of_overlaps(count);
  sphere_pairs(pairs_of(in), overlaps_of(whole));
  for (std::size_t offset = 1; offset < 4; ++offset)
  {
    Lists out = lists_of_overlaps(count + 8);
    const auto from = [&](std::size_t k) { return in[k].subspan(offset); };
    const auto to = [&](std::size_t k) { return out[k].subspan(offset + 1, count - offset); };
    sphere_pairs(
        {from(0), from(1), from(2), from(3), from(4), from(5), from(6), from(7)},
        {to(0), to(1), to(2), to(3), to(4), to(5), to(6)});
    int different = 0;
    for (std::size_t k = 0; k < 7; ++k)
    {
      for (std::size_t i = offset; i < count; ++i)
      {
        different += same_bits(out[k][i + 1], whole[k][i]) ? 0 : 1;
      }
      CHECK(out[k][offset] == 0);
      CHECK(out[k][count + 1] == 0);
    }
    CHECK(different == 0);
  }
}

TEST_CASE("unit spheres 3 apart have depth −1 and their point midway", "[sphere_pairs][S1]")
{
  const Lists in = lists_of_pairs({{{{0, 0, 0}, 1}, {{3, 0, 0}, 1}}});
  Lists out = lists_of_overlaps(1);
  sphere_pairs(pairs_of(in), overlaps_of(out));
  CHECK(out[0][0] == 1);
  CHECK(out[3][0] == -1);
  CHECK(out[4][0] == 1.5f);
}

TEST_CASE("lists of different lengths are refused, and nothing is written", "[sphere_pairs]")
{
  const Lists in = lists_of_pairs(random_pairs(5));
  Lists out = lists_of_overlaps(4);
  CHECK_THROWS_AS(sphere_pairs(pairs_of(in), overlaps_of(out)), std::invalid_argument);
  CHECK(out[3][0] == 0);
}

TEST_CASE("each list begins on a cache line, 5 lines further into its page", "[sphere_pairs]")
{
  for (const std::size_t length : std::initializer_list<std::size_t>{1, 1000, 1024, 2048, 5000})
  {
    const Lists lists(3, length);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto address = reinterpret_cast<std::uintptr_t>(lists[k].data());
      const auto first = reinterpret_cast<std::uintptr_t>(lists[0].data());
      CHECK(address % 64 == 0);
      CHECK((address - first) % 4096 == k * 5 * 64);
    }
  }
}
