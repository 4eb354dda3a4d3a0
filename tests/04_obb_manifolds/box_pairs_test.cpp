/// \file
/// \brief What holds for many pairs of boxes at once: the same answers as one by one, to the last
/// bit.

#include "04_obb_manifolds/box_box/box_box.hpp"
#include "04_obb_manifolds/box_failures/trial/box_failures.hpp"
#include "04_obb_manifolds/box_pairs/box_pairs.hpp"
#include "04_obb_manifolds/box_workloads/trial/box_workloads.hpp"
#include "04_obb_manifolds/feature_memory/contact_memory.hpp"

#include "tests/04_obb_manifolds/same_bits.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace cookbook;

namespace
{

using Pairs = std::vector<BoxPair<float>>;
using Answer = std::optional<Manifold<float>>;

/// So many pairs of each workload.
constexpr std::size_t many = inputs(20'000, 300);

/// How many of the batch's answers differ from `box_box` in any bit.
int differences(const Pairs& pairs, InstructionSet set)
{
  const std::vector<Answer> answers = box_pairs_in_order(pairs, set);
  int count = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    count += same_bits(answers[i], box_box(pairs[i].first, pairs[i].second)) ? 0 : 1;
  }
  return count;
}

/// In how many pairs the touch test and `box_box` disagree.
int wrong_touches(const Pairs& pairs, InstructionSet set)
{
  const BoxBlocks blocks = blocks_of(pairs);
  std::vector<std::uint32_t> touching(blocks.a.size());
  box_pairs_touch(blocks.a, blocks.b, touching, set);
  int count = 0;
  for (std::size_t i = 0; i < 16 * blocks.a.size(); ++i)
  {
    const bool expected = i < pairs.size() && box_box(pairs[i].first, pairs[i].second).has_value();
    count += touches_at(touching, i) == expected ? 0 : 1;
  }
  return count;
}

/// The pairs of the chapter's table of failing cases, in float.
std::vector<std::pair<std::string, BoxPair<float>>> failing_cases()
{
  std::vector<std::pair<std::string, BoxPair<float>>> cases;
  for (const BoxCase& row : all_box_cases())
  {
    cases.push_back({row.id, {to_float(row.a), to_float(row.b)}});
  }
  return cases;
}

/// A pair as large as given.
BoxPair<float> scaled_pair(const BoxPair<float>& pair, float scale)
{
  const auto scaled_box = [scale](const Obb<float>& box) -> Obb<float> {
    return {scale * box.center, box.axes, scale * box.half_extents};
  };
  return {scaled_box(pair.first), scaled_box(pair.second)};
}

/// Random pairs of another size, among others so small and so large that squares do not fit.
Pairs scaled_pairs(float scale, std::size_t count)
{
  Pairs pairs = box_workload("random", count).pairs;
  for (BoxPair<float>& pair : pairs)
  {
    pair = scaled_pair(pair, scale);
  }
  return pairs;
}

/// Boxes without height, length or any size, and boxes whose lengths are no sizes.
Pairs odd_pairs()
{
  const Matrix3<float> upright = Matrix3<float>::Identity();
  const float huge = std::numeric_limits<float>::max(), none = std::nanf("");
  const float infinite = std::numeric_limits<float>::infinity();
  Pairs pairs;
  for (const float size : {0.0f, 1e-45f, 1e-38f, 1e-30f, 1e20f, huge, infinite, none, -1.0f})
  {
    const Obb<float> cube{{0, 0, 0}, upright, {1, 1, 1}};
    pairs.push_back({cube, {{0.5f, 0, 0}, upright, {size, 1, 1}}});
    pairs.push_back({cube, {{0.5f, 0, 0}, upright, {size, size, size}}});
    pairs.push_back({{{0, 0, 0}, upright, {size, size, size}}, cube});
    pairs.push_back({cube, {{size, 0, 0}, upright, {1, 1, 1}}});
    pairs.push_back({cube, {{0, 0, size}, upright, {size, 1, size}}});
  }
  return pairs;
}

} // namespace

// [equal]
TEST_CASE("20,000 pairs of each workload at once have the bits of one by one", "[box_pairs]")
{
  for (const BoxRecipe& recipe : box_workload_recipes())
  {
    const BoxWorkload workload = box_workload(recipe, many);
    for (const InstructionSet set : instruction_sets())
    {
      INFO(workload.name << ", instruction set " << static_cast<int>(set));
      CHECK(differences(workload.pairs, set) == 0);
      CHECK(wrong_touches(workload.pairs, set) == 0);
    }
  }
}

TEST_CASE("every failing case, alone and among others, has the bits of one by one", "[box_pairs]")
{
  const Pairs ordinary = box_workload("random", 48).pairs;
  for (const auto& [id, pair] : failing_cases())
  {
    for (const InstructionSet set : instruction_sets())
    {
      INFO(id << ", instruction set " << static_cast<int>(set));
      CHECK(differences({pair, {pair.second, pair.first}}, set) == 0);
      CHECK(wrong_touches({pair, {pair.second, pair.first}}, set) == 0);
      for (std::size_t lane = 16; lane < 32; ++lane)
      {
        Pairs pairs = ordinary;
        pairs[lane] = pair;
        REQUIRE(differences(pairs, set) == 0);
      }
    }
  }
}
// [equal]

TEST_CASE("pairs too small and too large to square have the bits of one by one", "[box_pairs]")
{
  for (const InstructionSet set : instruction_sets())
  {
    for (const float scale :
         {1e-44f, 1e-38f, 1e-30f, 1e-19f, 1e-12f, 1e6f, 1e9f, 1e18f, 1e19f, 1e30f, 2e38f})
    {
      INFO("scale " << scale << ", instruction set " << static_cast<int>(set));
      CHECK(differences(scaled_pairs(scale, many / 10), set) == 0);
      CHECK(wrong_touches(scaled_pairs(scale, many / 10), set) == 0);
    }
  }
}

TEST_CASE("one pair too large leaves the others of its block as they were", "[box_pairs]")
{
  const Pairs ordinary = box_workload("random", 320).pairs;
  for (const InstructionSet set : instruction_sets())
  {
    for (const std::size_t lane : {0u, 37u, 255u, 256u, 319u})
    {
      for (const float scale : {1e-30f, 1e30f})
      {
        Pairs pairs = ordinary;
        pairs[lane] = scaled_pair(pairs[lane], scale);
        CHECK(differences(pairs, set) == 0);
        CHECK(wrong_touches(pairs, set) == 0);
      }
    }
  }
}

TEST_CASE("boxes without size, and with lengths that are none, answer as one by one", "[box_pairs]")
{
  const Pairs pairs = odd_pairs();
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    for (const InstructionSet set : instruction_sets())
    {
      INFO("odd pair " << i << ", instruction set " << static_cast<int>(set));
      CHECK(differences({pairs[i]}, set) == 0);
      CHECK(wrong_touches({pairs[i]}, set) == 0);
    }
  }
}

TEST_CASE("boxes that touch along edges and at corners answer as one by one", "[box_pairs]")
{
  const Matrix3<float> upright = Matrix3<float>::Identity();
  Pairs pairs = box_workload("random", 16).pairs;
  for (int i = 0; i < 343; ++i)
  {
    const Vector3<float> center(float(i % 7 - 3), float(i / 7 % 7 - 3), float(i / 49 - 3));
    pairs.push_back({{{0, 0, 0}, upright, {1, 1, 1}}, {center, upright, {2, 1, 1}}});
  }
  for (const InstructionSet set : instruction_sets())
  {
    INFO("instruction set " << static_cast<int>(set));
    CHECK(differences(pairs, set) == 0);
    CHECK(wrong_touches(pairs, set) == 0);
  }
}

TEST_CASE("0 to 33 pairs are answered", "[box_pairs]")
{
  const Pairs pairs = box_workload("random", 33).pairs;
  for (const InstructionSet set : instruction_sets())
  {
    for (std::size_t count = 0; count <= 33; ++count)
    {
      const Pairs some(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count));
      CHECK(differences(some, set) == 0);
      CHECK(wrong_touches(some, set) == 0);
    }
  }
}

TEST_CASE("each pair that touches has one manifold, in the list of its kind", "[box_pairs]")
{
  for (const char* const name : {"random", "resting", "edge-edge", "degenerate"})
  {
    Pairs pairs = box_workload(name, 1000).pairs;
    pairs[500] = scaled_pair(pairs[500], 1e30f);
    const BoxBlocks blocks = blocks_of(pairs);
    for (const InstructionSet set : instruction_sets())
    {
      BoxManifolds manifolds;
      box_pairs(blocks.a, blocks.b, manifolds, set);
      std::vector<int> found(pairs.size(), 0);
      for (std::size_t i = 0; i < manifolds.face_count; ++i)
      {
        const PairManifold answer = face_manifold_at(manifolds, i);
        CHECK(axis_of_feature(answer.manifold.points[0].feature) < 6);
        ++found.at(answer.pair);
      }
      for (std::size_t i = 0; i < manifolds.edge_count; ++i)
      {
        const PairManifold answer = edge_manifold_at(manifolds, i);
        CHECK(axis_of_feature(answer.manifold.points[0].feature) >= 6);
        ++found.at(answer.pair);
      }
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        CHECK(found[i] == (box_box(pairs[i].first, pairs[i].second) ? 1 : 0));
      }
    }
  }
}

TEST_CASE("room is made once, and fewer pairs leave it as it is", "[box_pairs]")
{
  const Pairs many_pairs = box_workload("resting", 333).pairs;
  const Pairs few_pairs = box_workload("random", 40).pairs;
  const BoxBlocks many_blocks = blocks_of(many_pairs), few_blocks = blocks_of(few_pairs);
  for (const InstructionSet set : instruction_sets())
  {
    BoxManifolds manifolds;
    box_pairs(many_blocks.a, many_blocks.b, manifolds, set);
    CHECK(manifolds.room == 21);
    const SixteenFaceManifolds* const before = manifolds.faces.get();
    box_pairs(few_blocks.a, few_blocks.b, manifolds, set);
    CHECK(manifolds.room == 21);
    CHECK(manifolds.faces.get() == before);
    const std::vector<Answer> answers = in_order(manifolds, few_pairs.size());
    for (std::size_t i = 0; i < few_pairs.size(); ++i)
    {
      CHECK(same_bits(answers[i], box_box(few_pairs[i].first, few_pairs[i].second)));
    }
  }
}

TEST_CASE("a block holds its pairs, and is filled with cubes that are apart", "[box_pairs]")
{
  const Pairs pairs = box_workload("random", 17).pairs;
  const BoxBlocks blocks = blocks_of(pairs);
  REQUIRE(blocks.a.size() == 2);
  REQUIRE(blocks.b.size() == 2);
  CHECK(blocks_of(std::span(pairs).first(16)).a.size() == 1);
  CHECK(blocks.a[1].center[1][0] == pairs[16].first.center.y());
  CHECK(blocks.b[0].axes[2][1][5] == pairs[5].second.axes(1, 2));
  CHECK(blocks.b[0].half_extents[2][15] == pairs[15].second.half_extents.z());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    CHECK(box_at(blocks.a, i).center == pairs[i].first.center);
    CHECK(box_at(blocks.b, i).axes == pairs[i].second.axes);
    CHECK(box_at(blocks.b, i).half_extents == pairs[i].second.half_extents);
  }
  BoxManifolds manifolds;
  box_pairs(blocks.a, blocks.b, manifolds);
  const std::vector<Answer> answers = in_order(manifolds, 32);
  CHECK(std::none_of(answers.begin() + 17, answers.end(), [](const Answer& m) { return bool(m); }));
}

TEST_CASE("a unit cube sunk by 1/8 into one below has four points that deep", "[box_pairs]")
{
  const Matrix3<float> upright = Matrix3<float>::Identity();
  const Obb<float> below{{0, 0, 0}, upright, {0.5f, 0.5f, 0.5f}};
  const Obb<float> above{{0.25f, 0.875f, 0}, upright, {0.5f, 0.5f, 0.5f}};
  for (const InstructionSet set : instruction_sets())
  {
    const Answer manifold = box_pairs_in_order(Pairs{{below, above}}, set)[0];
    REQUIRE(manifold);
    CHECK(manifold->normal == Vector3<float>(0, 1, 0));
    CHECK(manifold->depth == 0.125f);
    REQUIRE(manifold->points.size() == 4);
    for (const ContactPoint<float>& point : manifold->points)
    {
      CHECK(point.depth == 0.125f);
      CHECK(point.position.y() == 0.4375f);
      CHECK((point.position.x() == -0.25f || point.position.x() == 0.5f));
      CHECK(std::abs(point.position.z()) == 0.5f);
    }
  }
}

TEST_CASE("pairs that are apart are in no list, whatever their size", "[box_pairs]")
{
  const Obb<float> cube{{0, 0, 0}, Matrix3<float>::Identity(), {1, 1, 1}};
  const Obb<float> other{{3, 0, 0}, Matrix3<float>::Identity(), {1, 1, 1}};
  for (const float scale : {1e-30f, 1.0f, 1e30f})
  {
    const BoxBlocks blocks = blocks_of(Pairs{scaled_pair({cube, other}, scale)});
    BoxManifolds manifolds;
    box_pairs(blocks.a, blocks.b, manifolds);
    CHECK(manifolds.face_count == 0);
    CHECK(manifolds.edge_count == 0);
  }
}

TEST_CASE("lists of different lengths are refused, and nothing is written", "[box_pairs]")
{
  const BoxBlocks blocks = blocks_of(box_workload("random", 40).pairs);
  BoxManifolds manifolds;
  box_pairs(blocks.a, blocks.b, manifolds);
  const std::size_t before = manifolds.face_count;
  CHECK_THROWS_WITH(
      box_pairs(blocks.a, std::span(blocks.b).first(2), manifolds),
      "box_pairs: the lists must have one length, got 3 blocks of boxes A and 2 of boxes B");
  CHECK(manifolds.face_count == before);
  std::vector<std::uint32_t> touching(3, 7);
  CHECK_THROWS_AS(
      box_pairs_touch(blocks.a, std::span(blocks.b).first(2), touching), std::invalid_argument);
  CHECK_THROWS_WITH(
      box_pairs_touch(blocks.a, blocks.b, std::span(touching).first(2)),
      "box_pairs_touch: there are 3 blocks of boxes, and 2 words for their answers");
  CHECK(touching == std::vector<std::uint32_t>(3, 7));
}
