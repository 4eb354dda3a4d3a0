/// \file
/// What holds for a point and a plane, a segment and a box, as the formulas stand, and where it
/// ends.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "02_primitives/plain_points/plain_points.hpp"
#include "common/math/rotation.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [P1]
TEST_CASE("(3,4,5) is 4 above the plane 0.6x + 0.8y = 1, the origin is 1 below", "[P1]")
{
  const Plane<double> slope{{0.6, 0.8, 0}, 1};
  CHECK(signed_distance(slope, {3, 4, 5}) == Catch::Approx(4).epsilon(1e-14));
  CHECK(signed_distance(slope, {0, 0, 0}) == -1);
}
// [P1]

// [P2]
TEST_CASE("the point of (0,0)-(6,8) closest to (7,1) is (3,4), to far points an end", "[P2]")
{
  // (7,1) = 5 along (0.6, 0.8) and 5 across it.
  const Segment<double> segment{{0, 0, 0}, {6, 8, 0}};
  CHECK((closest_point(segment, {7, 1, 2}) - Vector3<double>(3, 4, 0)).norm() <= 1e-14);
  CHECK(closest_point(segment, {-1, -1, 0}) == Vector3<double>(0, 0, 0));
  CHECK(closest_point(segment, {7, 9, 0}) == Vector3<double>(6, 8, 0));
}

TEST_CASE("a segment of length 0 is its own closest point", "[P2]")
{
  const Segment<double> dot{{1, 2, 3}, {1, 2, 3}};
  CHECK(closest_point(dot, {9, 9, 9}) == Vector3<double>(1, 2, 3));
}
// [P2]

// [inside_moves]
TEST_CASE(
    "a point in an oriented box comes back moved by the plain formula, unmoved by closest_point",
    "[P4]")
{
  const Obb<double> box{{0, 0, 0}, rational_rotation<double>(5, 1, 2, 3), {1, 1, 1}};
  const Vector3<double> inside(0.5, 0.25, 0.25);
  CHECK(closest_on_box(box, inside) != inside);
  CHECK((closest_on_box(box, inside) - inside).norm() <= 1e-15);
  CHECK(closest_point(box, inside) == inside);
  const Vector3<double> above = inside + 4 * box.axes.col(2); // outside both agree
  CHECK((closest_on_box(box, above) - closest_point(box, above)).norm() <= 1e-15);
}
// [inside_moves]

// [plain_distance_of_box]
TEST_CASE("3 and 4 from an edge is 5 away, 0.5 below a face is -0.5, a corner is 0", "[P5]")
{
  const Obb<double> box{{0, 0, 0}, Matrix3<double>::Identity(), {2, 1, 1}};
  CHECK(signed_distance(box, {5, 5, 0}) == 5);
  CHECK(signed_distance(box, {-1.5, 0.25, 0}) == -0.5);
  CHECK(signed_distance(box, {2, -1, 1}) == 0);
}
// [plain_distance_of_box]

// [floor_of_20_km]
TEST_CASE(
    "above a float floor of 20 km the plain distance is 0.05 mm off, signed_distance_box not",
    "[P5]")
{
  const Matrix3<float> turned{{0.8f, -0.6f, 0}, {0.6f, 0.8f, 0}, {0, 0, 1}};
  const Obb<float> floor{{0, 0, 0}, turned, {10'000, 1, 10'000}};
  const Vector3<float> p(3999.1f, 3001.2f, 0); // 5 km from the middle, 0.5 m above
  const Vector3<double> exact(p.cast<double>());
  const double right = -double(0.6f) * exact.x() + double(0.8f) * exact.y() - 1;
  const Direction<double> out =
      signed_distance_box(box_coordinates(floor, p), widen(floor.half_extents));
  CHECK(std::abs(double(signed_distance(floor, p)) - right) > 5e-5);
  CHECK(std::abs(out.length - right) < 1e-12);
}
// [floor_of_20_km]
