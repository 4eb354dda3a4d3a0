/// \file
/// What makes a shape: every impossible number is named, with its value.

#include "02_primitives/shapes/checked_more_shapes.hpp"
#include "02_primitives/shapes/checked_shapes.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

namespace
{

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();
const Matrix3<double> upright = Matrix3<double>::Identity();

} // namespace

TEST_CASE("a sphere has finite numbers and a radius of zero or more", "[shapes]")
{
  CHECK(checked(Sphere<double>{{1, 2, 3}, 0}).center.y() == 2);
  CHECK_THROWS_WITH(
      checked(Sphere<double>{{0, 0, 0}, -1.5}), "radius must be zero or more, got -1.5");
  CHECK_THROWS_WITH(
      checked(Sphere<double>{{0, 0, 0}, not_a_number}), "radius must be finite, got nan");
  CHECK_THROWS_WITH(
      checked(Sphere<double>{{0, infinite, 0}, 1}), "center.y must be finite, got inf");
}

TEST_CASE("a box has volume and axes that are a rotation", "[shapes]")
{
  CHECK(checked(Obb<double>{{0, 0, 0}, upright, {1, 2, 3}}).half_extents.z() == 3);
  CHECK_THROWS_WITH(
      checked(Obb<double>{{0, 0, 0}, upright, {1, 0, 3}}),
      "half_extents.y must be greater than zero, got 0");
  CHECK_THROWS_WITH(
      checked(Obb<double>{{0, 0, 0}, 2 * upright, {1, 1, 1}}),
      "axes must be a rotation, got an error of 3");
  CHECK_THROWS_WITH(
      checked(Obb<double>{{0, 0, 0}, -upright, {1, 1, 1}}),
      "axes must be a rotation, got an error of 2");
  CHECK_THROWS_AS(
      (checked(Obb<double>{{0, 0, 0}, not_a_number * upright, {1, 1, 1}})), InvalidShape);
  CHECK_THROWS_AS((checked(Obb<double>{{0, 0, not_a_number}, upright, {1, 1, 1}})), InvalidShape);
}

TEST_CASE("a plane has a normal of length one", "[shapes]")
{
  CHECK(checked(Plane<double>{{0.6, 0.8, 0}, 1}).distance == 1);
  CHECK_THROWS_WITH(
      checked(Plane<double>{{0, 2, 0}, 1}), "normal must be of length one, got length 2");
  CHECK_THROWS_AS((checked(Plane<double>{{0, 1, 0}, infinite})), InvalidShape);
}

TEST_CASE("a capsule may have no length, but a radius of zero or more", "[shapes]")
{
  CHECK(checked(Capsule<double>{{{1, 1, 1}, {1, 1, 1}}, 2}).radius == 2);
  CHECK_THROWS_AS((checked(Capsule<double>{{{1, 1, 1}, {1, 1, 1}}, -2})), InvalidShape);
  CHECK_THROWS_AS((checked(Capsule<double>{{{1, 1, 1}, {1, not_a_number, 1}}, 2})), InvalidShape);
}

TEST_CASE("shapes of points have finite numbers; flat ones are shapes", "[shapes]")
{
  const Eigen::Vector3d o(0, 0, 0), bad(0, not_a_number, 0);
  CHECK(checked(Segment<double>{o, o}).end == o);
  CHECK(checked(Triangle<double>{o, o, o}).c == o);
  CHECK(checked(Tetrahedron<double>{o, o, o, o}).d == o);
  CHECK_THROWS_WITH(checked(Segment<double>{o, bad}), "end.y must be finite, got nan");
  CHECK_THROWS_WITH(checked(Triangle<double>{o, o, bad}), "c.y must be finite, got nan");
  CHECK_THROWS_WITH(checked(Tetrahedron<double>{o, o, o, bad}), "d.y must be finite, got nan");
}

TEST_CASE("a box along the axes has its corners in order, a ray points somewhere", "[shapes]")
{
  const Eigen::Vector3d o(0, 0, 0), one(1, 1, 1);
  CHECK(checked(Aabb<double>(o, one)).max() == one);
  CHECK(checked(Aabb<double>(o, o)).max() == o);
  CHECK_THROWS_WITH(
      checked(Aabb<double>(one, Eigen::Vector3d(1, 0, 1))), "max.y must be min or more, 1, got 0");
  CHECK(checked(Ray<double>{o, 2 * one}).direction == 2 * one);
  CHECK_THROWS_WITH(checked(Ray<double>{o, o}), "direction must be other than zero, got 0, 0, 0");
  CHECK_THROWS_AS((checked(Ray<double>{o, infinite * one})), InvalidShape);
  CHECK_THROWS_WITH(
      checked(Ray<double>{{0, not_a_number, 0}, one}), "origin.y must be finite, got nan");
}
