/// \file
/// Which bodies may touch: sorted and swept, against every pair.

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
TEST_CASE("sorted and swept, no pair is missed and none comes twice", "[case:L5]")
{
  BoxDraw draw(11);
  int wrong = 0;
  std::size_t found = 0;
  for (int i = 0; i < scenes_asked; ++i)
  {
    std::vector<Bounds> bounds = random_bounds(draw);
    const auto wanted = every_overlapping_pair(bounds);
    wrong += overlapping_pairs(bounds) != wanted ? 1 : 0;
    wrong += overlapping_pairs(bounds) != wanted ? 1 : 0; // in the order that was left
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
    CHECK(overlapping_pairs(bounds).size() == pairs);
  }
}
// [L5]
