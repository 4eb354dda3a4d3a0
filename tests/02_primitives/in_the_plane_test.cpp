/// \file
/// What holds for shapes in the plane, by hand; polygons by separating axes; and where ways fail.

#include "02_primitives/in_the_plane/in_the_plane.hpp"
#include "02_primitives/in_the_plane/trial/plane_cases.hpp"
#include "02_primitives/in_the_plane/trial/plane_truth.hpp"
#include "02_primitives/shapes/trial/number_draw.hpp"

#include "tests/02_primitives/plane_inputs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"
#include "tests/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace cookbook;

namespace
{

using Point = Vector<double, 2>;

/// A triangle of the grid, counter-clockwise; it may be flat.
std::array<Point, 3> draw_triangle(GridDraw& draw, GridShape& grid)
{
  std::array<Point, 3> triangle;
  std::array<GridShape, 3> one;
  for (std::size_t i = 0; i < 3; ++i)
  {
    draw(triangle[i], one[i]);
  }
  grid.corners = {one[0].corners[0], one[1].corners[0], one[2].corners[0]};
  if (cross_of(grid.corners[1] - grid.corners[0], grid.corners[2] - grid.corners[0]) < 0)
  {
    std::swap(grid.corners[1], grid.corners[2]);
  }
  return triangle;
}

} // namespace

// [closest_by_hand]
TEST_CASE("a circle 3 from a corner, a segment and a turned rectangle have distances by hand")
{
  // The corner (3, 4) is 5 from the origin.
  const auto corner = closest_points(Circle<double>{{0, 0}, 2}, Rectangle<double>{{5, 5}, {2, 1}});
  CHECK(corner.distance == 3);
  CHECK((corner.a - Point(1.2, 1.6)).norm() <= 1e-15);
  CHECK((corner.b - Point(3, 4)).norm() <= 1e-15);
  // Turned by 3-4-5, a square's corner points along x: (1.4, -0.2) is one of its corners.
  const OrientedRectangle<double> oriented{{0, 0}, std::atan2(3, 4), {1, 1}};
  const auto face = closest_points(Segment2<double>{{5, -1}, {5, 9}}, oriented);
  CHECK(std::abs(face.distance - 3.6) <= 1e-14);
  CHECK((face.b - Point(1.4, -0.2)).norm() <= 1e-14);
}

TEST_CASE("two bars that cross have no corner in each other, and a common point")
{
  const Rectangle<double> flat{{0, 0}, {3, 1}}, high{{0, 0}, {1, 3}};
  const auto found = closest_points(flat, high);
  CHECK(found.distance == 0);
  CHECK(found.a == found.b);
  CHECK(contains(flat, found.a));
  CHECK(contains(high, found.a));
}
// [closest_by_hand]

// [holds]
TEST_CASE("a shape holds its edge, and nothing a millionth beyond it")
{
  const Rectangle<double> box{{1, 2}, {3, 4}};
  CHECK(contains(box, Point(4, 6)));
  CHECK_FALSE(contains(box, Point(4 + 1e-6, 6)));
  const Circle<double> circle{{1, 1}, 5};
  CHECK(contains(circle, Point(4, 5)));
  CHECK_FALSE(contains(circle, Point(4, 5 + 1e-6)));
  const Segment2<double> segment{{0, 0}, {2, 4}};
  CHECK(contains(segment, Point(1, 2)));
  CHECK_FALSE(contains(segment, Point(1, 2 + 1e-6)));
  CHECK_FALSE(contains(segment, Point(3, 6)));
  const OrientedRectangle<double> oriented{{0, 0}, std::atan2(3, 4), {5, 1}};
  CHECK(contains(oriented, Point(3.9, 3)));
  CHECK_FALSE(contains(oriented, Point(4.1, 3.1)));
}
// [holds]

// [projections]
TEST_CASE(
    "the projection of a unit square on (1, 1) is from 0 to 2, and of one at (2, 1) from 3 to 5")
{
  const std::array<Point, 4> a{Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)};
  const std::array<Point, 4> b{Point(2, 1), Point(3, 1), Point(3, 2), Point(2, 2)};
  const auto of_a = projection_on<double>(a, {1, 1}), of_b = projection_on<double>(b, {1, 1});
  CHECK(of_a.least == 0);
  CHECK(of_a.most == 2);
  CHECK(of_b.least == 3);
  CHECK(of_b.most == 5);
  CHECK(separates<double>({1, 1}, a, b));
  CHECK_FALSE(separates<double>({0, 1}, a, b)); // they touch there
}

TEST_CASE("two triangles that are apart on neither x nor y are apart perpendicular to an edge")
{
  const std::array<Point, 3> a{Point(0, 0), Point(4, 0), Point(0, 4)};
  const std::array<Point, 3> b{Point(4, 4), Point(1, 4), Point(4, 1)};
  const auto axis = separating_axis<double>(a, b);
  REQUIRE(axis);
  CHECK(std::abs(axis->x()) == std::abs(axis->y()));
  // Moved by (1/2, 1/2), they touch along an edge; by a little more, they overlap.
  std::array<Point, 3> touching = b;
  for (Point& corner : touching)
  {
    corner -= Point(0.5, 0.5);
  }
  CHECK(overlaps<double>(a, touching));
  CHECK(overlaps<double>(touching, a));
}
// [projections]

// [polygons]
TEST_CASE("triangles of a grid, flat ones and points too: the verdict is the exact one")
{
  GridDraw draw(3);
  int wrong = 0, separate = 0;
  for (int i = 0; i < random_inputs; ++i)
  {
    GridShape on_a, on_b;
    const std::array<Point, 3> a = draw_triangle(draw, on_a), b = draw_triangle(draw, on_b);
    const bool truth = truth_of(on_a, on_b).overlap;
    separate += truth ? 0 : 1;
    // At both ends of the range, too.
    const double scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 0x1p-1060 : 0x1p1015;
    std::array<Point, 3> scaled_a = a, scaled_b = b;
    for (std::size_t k = 0; k < 3; ++k)
    {
      scaled_a[k] *= scale;
      scaled_b[k] *= scale;
    }
    wrong += overlaps<double>(scaled_a, scaled_b) == truth ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(separate > 0);
}
// [polygons]

TEST_CASE("circles 3-4-5 apart leave along (3, 4) / 5; about one centre, along +y", "[case:B5]")
{
  const auto translation = minimum_translation<double>({{0, 0}, 4}, {{3, 4}, 2});
  CHECK((translation.normal - Point(0.6, 0.8)).norm() <= 1e-15);
  CHECK(translation.depth == 1);
  CHECK(minimum_translation<double>({{0, 0}, 1}, {{3, 4}, 2}).depth == -2);
  const auto same = minimum_translation<double>({{3, 3}, 1}, {{3, 3}, 1});
  CHECK(same.normal == Point(0, 1));
  CHECK(same.depth == 2);
}

TEST_CASE("circles that touch but for a rounding overlap if, and only if, none is between them")
{
  // 3² and 4² make 5²; the number after 3 makes a sum after 25, whose root is 5.
  const Circle<double> a{{0, 0}, 2}, beyond{{std::nextafter(3, 4), 4}, 3};
  CHECK_FALSE(overlaps(a, beyond));
  CHECK(closest_points(a, beyond).distance > 0);
  CHECK(minimum_translation(a, beyond).depth < 0);
  NumberDraw<double> draw(4);
  int different = 0, separate = 0;
  for (int i = 0; i < 10'000; ++i)
  {
    const Vector3<double> first = draw.in_box(0, 1), second = draw.in_box(0, 1);
    const Circle<double> one{first.head<2>(), first.z()};
    const Point to_other = second.head<2>();
    const Circle<double> other{one.center + to_other, to_other.norm() - one.radius};
    if (other.radius >= 0)
    {
      const bool meet = overlaps(one, other);
      separate += meet ? 0 : 1;
      different += (closest_points(one, other).distance == 0) == meet ? 0 : 1;
      different += (minimum_translation(one, other).depth >= 0) == meet ? 0 : 1;
    }
  }
  CHECK(different == 0);
  CHECK(separate > 1000);
}

// [plane_verdicts]
TEST_CASE(
    "each way to answer in the plane holds or fails as the table says",
    "[case:B1][case:B2][case:B3][case:B5][case:X39]")
{
  const std::string published = "as published", epsilon = "with an epsilon", ours = "recommended";
  check_verdicts(
      verdicts_in_plane(), names_in_plane(),
      {{"B2", {epsilon, ours}},
       {"8 m beyond a segment's end", {epsilon, ours}},
       {"0.05 mm above a segment", {published, ours}},
       {"B3", {ours}},
       {"a circle over its middle", {published, epsilon, ours}},
       {"B1", {epsilon, ours}},
       {"along the diagonal", {published, epsilon, ours}},
       {"along x, a thin one 90 m away", {ours}},
       {"B5", {epsilon, ours}},
       {"circles of 0.2 µm, half overlapped", {published, ours}}});
}
// [plane_verdicts]

TEST_CASE("a circle of 1e-300 m leaves one of 1 m, 1e9 m away, as a point does")
{
  const auto translation = minimum_translation<double>({{1e9, 0}, 1}, {{1e-300, 0}, 1e-300});
  CHECK(translation.normal == Point(-1, 0));
  CHECK(translation.depth == 1 - 1e9);
}

TEST_CASE("two squares one above the other are parted along y")
{
  const std::array<Point, 4> a{Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)};
  const std::array<Point, 4> b{Point(0, 3), Point(1, 3), Point(1, 4), Point(0, 4)};
  const auto axis = separating_axis<double>(a, b);
  REQUIRE(axis);
  CHECK(*axis == Point(0, 1));
}

TEST_CASE("the order of two shapes that touch but for rounding changes no verdict")
{
  std::mt19937 engine{11};
  const auto number = [&] { return std::ldexp(static_cast<double>(engine()), -31) - 1; };
  int apart = 0, touching = 0;
  for (int i = 0; i < 20'000; ++i)
  {
    // The second starts at a point of the first that is rounded.
    const Point start(number(), number()), along(number(), number()), other(number(), number());
    const Segment2<double> a{start, start + along};
    const Point at = start + std::abs(number()) * along;
    const Segment2<double> b{at, at + other};
    REQUIRE(overlaps(a, b) == overlaps(b, a));
    ++(overlaps(a, b) ? touching : apart);
  }
  CHECK((apart > 1000 && touching > 1000));
}
