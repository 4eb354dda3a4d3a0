/// \file
/// What holds for circles and rectangles around points and shapes in the plane: formula P22.

#include "02_primitives/bounding_circle/bounding_circle.hpp"
#include "tools/exact/exact.hpp"

#include "tests/02_primitives/plane_inputs.hpp"
#include "tests/catch.hpp"
#include "tests/random_inputs.hpp"

#include <optional>
#include <vector>

using namespace cookbook;

namespace
{

using Point = Vector<double, 2>;

/// The squared radius of the smallest circle around whole points, exactly: the least of all circles
/// on two or through three of them that hold all.
Rational exact_square(const std::vector<GridPoint>& points)
{
  std::optional<Rational> least;
  const auto consider = [&](const Rational& x, const Rational& y, const Rational& squared)
  {
    bool holds = !least || squared < *least;
    for (std::size_t i = 0; holds && i < points.size(); ++i)
    {
      const Rational dx = x - points[i].x, dy = y - points[i].y;
      holds = dx * dx + dy * dy <= squared;
    }
    least = holds ? squared : least;
  };
  for (const GridPoint& a : points)
  {
    for (const GridPoint& b : points)
    {
      const GridPoint to_b = b - a;
      consider(Rational(a.x + b.x) / 2, Rational(a.y + b.y) / 2, Rational(dot_of(to_b, to_b)) / 4);
      for (const GridPoint& c : points)
      {
        const GridPoint to_c = c - a;
        const std::int64_t twice = 2 * cross_of(to_b, to_c);
        if (twice != 0)
        {
          const std::int64_t bb = dot_of(to_b, to_b), cc = dot_of(to_c, to_c);
          const Rational x = Rational(to_c.y * bb - to_b.y * cc) / twice;
          const Rational y = Rational(to_b.x * cc - to_c.x * bb) / twice;
          consider(a.x + x, a.y + y, x * x + y * y);
        }
      }
    }
  }
  return *least;
}

template <class Real>
std::vector<Vector<Real, 2>> draw_points(GridDraw& draw, std::vector<GridPoint>& grid, int count)
{
  std::vector<Vector<Real, 2>> points;
  grid.clear();
  for (int i = 0; i < count; ++i)
  {
    grid.push_back({draw.whole(-9, 9), draw.whole(-9, 9)});
    points.push_back({Real(grid.back().x), Real(grid.back().y)});
  }
  return points;
}

template <class Real>
int points_left_out(const Circle<Real>& circle, const std::vector<Vector<Real, 2>>& points)
{
  int out = 0;
  for (const Vector<Real, 2>& point : points)
  {
    out += contains(circle, point) ? 0 : 1;
  }
  return out;
}

} // namespace

// [P22]
TEST_CASE("the smallest circle around (1,0), (4,0), (0,3) and (1,1) rests on two of them", "[P22]")
{
  const std::vector<Point> points{{1, 0}, {4, 0}, {0, 3}, {1, 1}};
  const Circle<double> least = minimal_circle<double>(points);
  CHECK(least.center == Point(2, 1.5));
  CHECK(least.radius == 2.5);
  // Their mean is (1.5, 1), from which (4, 0) is the farthest.
  const Circle<double> centroid = centroid_circle<double>(points);
  CHECK(centroid.center == Point(1.5, 1));
  CHECK(centroid.radius == Catch::Approx(std::hypot(2.5, 1)).epsilon(1e-15));
}

TEST_CASE(
    "two points, the second of them 999 times: the mean's circle is nearly twice as large", "[P22]")
{
  std::vector<Point> points(1000, Point(1, 0));
  points[0] = Point(-1, 0);
  CHECK(minimal_circle<double>(points).radius == 1);
  CHECK(centroid_circle<double>(points).radius == Catch::Approx(1.998).epsilon(1e-12));
}
// [P22]

// [P22_exact]
TEMPLATE_TEST_CASE(
    "the smallest circle has the exact radius, and r_min <= r_centroid <= 2 r_min", "[P22]", float,
    double)
{
  using Real = TestType;
  GridDraw draw(5);
  int wrong = 0, out = 0, longer = 0;
  // Each circle holds all points; an exact search takes a millisecond.
  for (int i = 0; i < random_inputs / 200; ++i)
  {
    std::vector<GridPoint> grid;
    const auto points = draw_points<Real>(draw, grid, 1 + i % 6);
    const double exact = std::sqrt(static_cast<double>(exact_square(grid)));
    const Circle<Real> least = minimal_circle<Real>(points);
    wrong += std::abs(double(least.radius) - exact) <=
                     4 * 13 * double(std::numeric_limits<Real>::epsilon())
                 ? 0
                 : 1;
    const Circle<Real> centroid = centroid_circle<Real>(points);
    longer += double(centroid.radius) > 2 * exact * (1 + 1e-6) ? 1 : 0;
    out += points_left_out(least, points) + points_left_out(centroid, points);
  }
  CHECK(wrong == 0);
  CHECK(out == 0);
  CHECK(longer == 0);
}
// [P22_exact]

// [circles_anywhere]
TEMPLATE_TEST_CASE(
    "far away, on a line, twice the same, tiny and huge: circles and rectangles hold all points",
    "[P22]", float, double)
{
  using Real = TestType;
  std::mt19937 engine(9);
  const auto fraction = [&] { return double(engine()) / 4294967296.0 * 2 - 1; };
  int out = 0, order = 0;
  for (int i = 0; i < random_inputs / 10; ++i)
  {
    const double size = std::ldexp(1, int(engine() % 160) - 80);
    const double place = i % 3 == 0 ? 0 : fraction() * size * std::ldexp(1, int(engine() % 40));
    const double flat = i % 4 == 0 ? 0 : i % 4 == 1 ? 1e-12 : 1;
    std::vector<Vector<Real, 2>> points;
    for (int k = 0; k < 1 + i % 20; ++k)
    {
      const double along = fraction();
      points.push_back(
          {Real(place + size * along), Real(place + size * (along / 3 + flat * fraction()))});
    }
    points.push_back(points[0]);
    const Circle<Real> least = minimal_circle<Real>(points);
    const Circle<Real> centroid = centroid_circle<Real>(points);
    const Rectangle<Real> rectangle = bounding_rectangle<Real>(points);
    out += points_left_out(least, points) + points_left_out(centroid, points);
    for (const Vector<Real, 2>& point : points)
    {
      out += contains(rectangle, point) ? 0 : 1;
    }
    // The centre is rounded to the last place of the coordinates.
    const Real tolerance = 8 * std::numeric_limits<Real>::epsilon() * largest(rectangle);
    order += least.radius <= centroid.radius + tolerance &&
                     centroid.radius <= 2 * least.radius + tolerance &&
                     rectangle.half_extents.maxCoeff() <= least.radius + tolerance
                 ? 0
                 : 1;
  }
  CHECK(out == 0);
  CHECK(order == 0);
}
// [circles_anywhere]

// [bounds_of_shapes]
TEST_CASE("bounds of a segment, a circle, a rectangle and one turned by 3-4-5, by hand")
{
  const Segment2<double> segment{{1, 1}, {4, 5}};
  CHECK(bounding_circle(segment).center == Point(2.5, 3));
  CHECK(bounding_circle(segment).radius == 2.5);
  CHECK(bounding_rectangle(segment).half_extents == Point(1.5, 2));
  const Circle<double> circle{{1, 2}, 3};
  CHECK(bounding_circle(circle).radius == 3);
  CHECK(bounding_rectangle(circle).center == Point(1, 2));
  CHECK(bounding_rectangle(circle).half_extents == Point(3, 3));
  const Rectangle<double> rectangle{{1, 2}, {3, 4}};
  CHECK(bounding_circle(rectangle).radius == 5);
  CHECK(bounding_rectangle(rectangle).half_extents == Point(3, 4));
  const OrientedRectangle<double> oriented{{1, 2}, std::atan2(3, 4), {3, 4}};
  CHECK(bounding_circle(oriented).radius == Catch::Approx(5).epsilon(1e-15));
  // 3 × 4/5 + 4 × 3/5, and 3 × 3/5 + 4 × 4/5.
  CHECK((bounding_rectangle(oriented).half_extents - Point(4.8, 5)).norm() <= 1e-14);
}
// [bounds_of_shapes]

TEST_CASE("at both ends of the range, bounds are finite and right")
{
  const std::vector<Point> huge{{-0x1p1022, 0}, {0x1p1022, 0}, {0, 0x1p1021}};
  CHECK(minimal_circle<double>(huge).radius == 0x1p1022);
  CHECK(bounding_rectangle<double>(huge).half_extents == Point(0x1p1022, 0x1p1020));
  const std::vector<Point> tiny{{0, 0}, {0x1p-1070, 0}, {0x1p-1070, 0}};
  CHECK(minimal_circle<double>(tiny).radius == 0x1p-1071);
}
