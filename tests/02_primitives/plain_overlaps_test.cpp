/// \file
/// What holds for overlaps of spheres and boxes, as the formulas stand, and where it ends.

#include "02_primitives/boxes_overlap/boxes_overlap.hpp"
#include "02_primitives/plain_overlaps/plain_overlaps.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

#include <random>

using namespace cookbook;

// [plain_overlaps_by_hand]
TEST_CASE("spheres and boxes along the axes: touching counts, a rounding more does not", "[plain]")
{
  using V = Vector3<double>;
  const Aabb<double> crate(V(-1, -1, -1), V(1, 1, 1));
  CHECK(spheres_overlap<double>({{0, 0, 0}, 2}, {{3, 4, 0}, 3})); // 5 apart
  CHECK_FALSE(spheres_overlap<double>({{0, 0, 0}, 2}, {{3, 4, 0}, 2.9}));
  CHECK(aabbs_overlap(crate, {V(1, 1, 1), V(2, 2, 2)}));
  CHECK_FALSE(aabbs_overlap(crate, {V(1.1, 0, 0), V(2, 1, 1)}));
  CHECK(sphere_aabb_overlap<double>({{4, 5, 0}, 5}, crate)); // 3 and 4 from an edge
  CHECK_FALSE(sphere_aabb_overlap<double>({{4, 5, 0}, 4.9}, crate));
}

TEST_CASE(
    "the diamond at (1.9, 1.9) is 0.26 away along its own axis, though the boxes around overlap",
    "[P6]")
{
  const Matrix3<double> turned{{0.8, -0.6, 0}, {0.6, 0.8, 0}, {0, 0, 1}};
  const Obb<double> box{{0, 0, 0}, Matrix3<double>::Identity(), {1, 1, 1}};
  CHECK_FALSE(obbs_overlap(box, {{1.9, 1.9, 0}, turned, {1, 1, 1}}));
  CHECK(obbs_overlap(box, {{1.7, 1.7, 0}, turned, {1, 1, 1}})); // 2.38 < 1 + 1.4
  CHECK(aabbs_overlap(bounds_of(box), bounds_of(Obb<double>{{1.9, 1.9, 0}, turned, {1, 1, 1}})));
}
// [plain_overlaps_by_hand]

// [turned_boxes_that_touch]
TEST_CASE(
    "oriented boxes that touch: the plain test denies some to rounding, boxes_overlap none",
    "[plain]")
{
  std::mt19937 random(4);
  int denied = 0, denied_by_hardened = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const auto draw = [&] { return int(random() % 9); };
    const Matrix3<double> axes = rational_rotation<double>(1 + draw(), draw(), draw(), draw());
    const Obb<double> below{{0.1, 0.2, 0.3}, axes, {1, 0.5, 1}};
    const Obb<double> above{below.center + axes.col(1), axes, {1, 0.5, 1}};
    denied += obbs_overlap(below, above) ? 0 : 1;
    denied_by_hardened += boxes_overlap(below, above) ? 0 : 1;
  }
  CHECK(denied > 20);
  CHECK(denied_by_hardened == 0);
}
// [turned_boxes_that_touch]

TEST_CASE(
    "100,000 pairs of boxes in a room: fifteen plain axes say what boxes_overlap says", "[plain]")
{
  std::mt19937 random(5);
  const auto draw = [&] { return double(random()) * 0x1p-31 - 1; };
  const auto box = [&]() -> Obb<double>
  {
    const auto whole = [&] { return int(random() % 9); };
    return {
        {draw(), draw(), draw()},
        rational_rotation<double>(1 + whole(), whole(), whole(), whole()),
        {0.6 + draw() / 2, 0.6 + draw() / 2, 0.6 + draw() / 2}};
  };
  int different = 0, overlap = 0;
  for (int i = 0; i < 100'000; ++i)
  {
    const Obb<double> a = box(), b = box();
    overlap += obbs_overlap(a, b) ? 1 : 0;
    different += obbs_overlap(a, b) != boxes_overlap(a, b) ? 1 : 0;
  }
  CHECK(different == 0);
  CHECK((overlap > 20'000 && overlap < 90'000));
}

// [sphere_around]
TEST_CASE("around the corners of a box of 2, 4, 4 the sphere has radius 3", "[plain]")
{
  std::vector<Vector3<double>> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 2.0 : -2.0, i & 4 ? 2.0 : -2.0});
  }
  const Sphere<double> sphere = sphere_around(corners);
  CHECK((sphere.center == Vector3<double>(0, 0, 0) && sphere.radius == 3)); // 1 + 4 + 4 = 9
}
// [sphere_around]
