/// \file
/// What makes a shape in the plane: every impossible number is named, with its value.

#include "02_primitives/shapes/checked_plane_shapes.hpp"

#include "tests/catch.hpp"

#include <limits>

using namespace cookbook;

namespace
{

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("segments and rays have finite numbers, and a ray has a direction", "[plane_shapes]")
{
  CHECK(checked(Segment2<double>{{1, 2}, {1, 2}}).end.y() == 2);
  CHECK_THROWS_WITH(
      checked(Segment2<double>{{1, infinite}, {1, 2}}), "start.y must be finite, got inf");
  CHECK_THROWS_WITH(
      checked(Segment2<double>{{1, 2}, {not_a_number, 2}}), "end.x must be finite, got nan");
  CHECK(checked(Ray2<double>{{0, 0}, {0, 1e-300}}).direction.x() == 0);
  CHECK_THROWS_WITH(
      checked(Ray2<double>{{0, 0}, {0, 0}}), "direction must be other than zero, got (0, 0)");
  CHECK_THROWS_WITH(
      checked(Ray2<double>{{0, 0}, {0, infinite}}), "direction.y must be finite, got inf");
  CHECK_THROWS_WITH(
      checked(Ray2<double>{{not_a_number, 0}, {0, 1}}), "origin.x must be finite, got nan");
}

TEST_CASE("a circle has a radius of zero or more", "[plane_shapes]")
{
  CHECK(checked(Circle<double>{{1, 2}, 0}).center.y() == 2);
  CHECK_THROWS_WITH(checked(Circle<double>{{0, 0}, -1.5}), "radius must be zero or more, got -1.5");
  CHECK_THROWS_WITH(
      checked(Circle<double>{{0, not_a_number}, 1}), "center.y must be finite, got nan");
  CHECK_THROWS_WITH(checked(Circle<double>{{0, 0}, infinite}), "radius must be finite, got inf");
}

TEST_CASE("a rectangle may be flat, but not less", "[plane_shapes]")
{
  CHECK(checked(Rectangle<double>{{1, 2}, {3, 0}}).half_extents.y() == 0);
  CHECK_THROWS_WITH(
      checked(Rectangle<double>{{0, 0}, {1, -1}}), "half_extents.y must be zero or more, got -1");
  CHECK_THROWS_WITH(
      checked(Rectangle<double>{{0, 0}, {infinite, 1}}), "half_extents.x must be finite, got inf");
  CHECK_THROWS_AS((checked(Rectangle<double>{{infinite, 0}, {1, 1}})), InvalidShape);
  CHECK(checked(OrientedRectangle<double>{{1, 2}, 100, {0, 0}}).angle == 100);
  CHECK_THROWS_WITH(
      checked(OrientedRectangle<double>{{0, 0}, not_a_number, {1, 1}}),
      "angle must be finite, got nan");
  CHECK_THROWS_WITH(
      checked(OrientedRectangle<double>{{0, 0}, 0, {-2, 1}}),
      "half_extents.x must be zero or more, got -2");
  CHECK_THROWS_AS((checked(OrientedRectangle<double>{{infinite, 0}, 0, {1, 1}})), InvalidShape);
}
