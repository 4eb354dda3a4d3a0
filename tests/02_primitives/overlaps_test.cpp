/// \file
/// What holds for the overlap of any two shapes.

#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/plain_overlaps/plain_overlaps.hpp"

#include "tests/02_primitives/shape_pairs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

using namespace cookbook;

// [overlaps_in_float]
TEST_CASE("45 pairs of shapes in float: as good as float can write the answer", "[overlaps]")
{
  for (const Kinds<float>& kinds : all_kinds<float>())
  {
    for (const Draws draws : all_draws)
    {
      const Wrongs wrongs = check_pairs(kinds, draws, inputs(14'285, 70));
      INFO(kinds.names << ", draws " << int(draws) << ", overlapping " << wrongs.overlapping);
      CHECK(wrongs.fault < 2e-6L);
      CHECK(wrongs.contradictions == 0);
    }
  }
}
// [overlaps_in_float]

TEST_CASE(
    "boxes along the axes that touch overlap, to the last bit; an empty one never", "[overlaps]")
{
  using V = Eigen::Vector3d;
  const Aabb<double> box(V(0, 0, 0), V(1, 1, 1));
  CHECK(aabbs_overlap(box, Aabb<double>(V(1, 1, 1), V(2, 2, 2))));
  CHECK_FALSE(aabbs_overlap(box, Aabb<double>(V(1 + 0x1p-52, 0, 0), V(2, 2, 2))));
  CHECK_FALSE(aabbs_overlap(box, Aabb<double>(V(0, 0, -1e-300), V(1, 1, -1e-300))));
  CHECK_FALSE(aabbs_overlap(box, Aabb<double>()));
}

TEST_CASE("a sphere and a box: before a face, an edge and a corner, and inside", "[overlaps]")
{
  using V = Eigen::Vector3d;
  const Aabb<double> box(V(-1, -2, -3), V(1, 2, 3));
  CHECK(sphere_aabb_overlap({{3, 0, 0}, 2}, box));
  CHECK_FALSE(sphere_aabb_overlap({{3, 0, 0}, 1.999}, box));
  CHECK(sphere_aabb_overlap({{4, 6, 0}, 5}, box)); // 3, 4, 0 from the edge
  CHECK_FALSE(sphere_aabb_overlap({{4, 6, 0}, 4.999}, box));
  CHECK(sphere_aabb_overlap({{3, 5, 9}, 7}, box)); // 2, 3, 6 from the corner
  CHECK_FALSE(sphere_aabb_overlap({{3, 5, 9}, 6.999}, box));
  CHECK(sphere_aabb_overlap({{0, 0, 0}, 0}, box));
}
