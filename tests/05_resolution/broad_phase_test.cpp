/// \file
/// Which bodies may touch: by a tree, and sorted and swept, against every pair.

#include "04_obb_manifolds/box_workloads/trial/random_boxes.hpp"
#include "05_resolution/world_chart/trial/broad_phase_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <limits>

using namespace cookbook;

namespace
{

/// Up to 24 bounds with sides of a few whole numbers, so that many only touch, and maybe a plane.
std::vector<Bounds> random_bounds(BoxDraw& draw)
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Bounds> bounds;
  const int count = draw.whole(24);
  for (int i = 0; i < count; ++i)
  {
    const Vector3<double> low(draw.whole(12), draw.whole(12), draw.whole(12));
    const Vector3<double> size(draw.whole(4), draw.whole(4), draw.whole(4));
    bounds.push_back({{low, low + size}, i});
  }
  if (draw.whole(2) == 0)
  {
    const Vector3<double> far = Vector3<double>::Constant(infinity);
    bounds.push_back({{-far, far}, count});
  }
  return bounds;
}

constexpr int scenes_asked = inputs(100'000, 2'000);

} // namespace

// [L5]
TEST_CASE(
    "by a tree, no pair is missed and none comes twice; sorted and swept neither", "[case:L5]")
{
  BoxDraw draw(11);
  BroadPhase tree;
  int wrong = 0;
  std::size_t found = 0;
  for (int i = 0; i < scenes_asked; ++i)
  {
    std::vector<Bounds> bounds = random_bounds(draw);
    const auto wanted = every_overlapping_pair(bounds);
    wrong += tree.pairs(bounds) != wanted ? 1 : 0;
    wrong += swept_pairs(bounds) != wanted ? 1 : 0;
    found += wanted.size();
  }
  CHECK(wrong == 0);
  CHECK(found > 5 * static_cast<std::size_t>(scenes_asked));
}

TEST_CASE("a grid of boxes has its 8 neighbours, less at the sides", "[case:L6]")
{
  for (const int side : {2, 8, 64})
  {
    std::vector<Bounds> bounds = grid_bounds(side * side);
    // Two rows of pairs along the sides, and two along the diagonals.
    const auto pairs =
        static_cast<std::size_t>(2 * side * (side - 1) + 2 * (side - 1) * (side - 1));
    CHECK(BroadPhase().pairs(bounds).size() == pairs);
    CHECK(swept_pairs(bounds).size() == pairs);
  }
}

TEST_CASE("10,000 boxes in a row along any axis have 9,999 pairs; all in one place too many")
{
  for (int axis = 0; axis < 3; ++axis)
  {
    CHECK(BroadPhase().pairs(row_bounds(10'000, axis)).size() == 9'999);
  }
  // 300 in one place are 44,850 pairs, more than 100 for each.
  std::vector<Bounds> heaped = row_bounds(300, 0);
  for (Bounds& one : heaped)
  {
    one.box = heaped.front().box;
  }
  CHECK_THROWS_AS(BroadPhase().pairs(heaped), TooManyContacts);
  heaped.resize(201);
  CHECK(BroadPhase().pairs(heaped).size() == 20'100);
}
// [L5]
