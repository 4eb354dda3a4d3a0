/// \file
/// What holds for circles and rectangles around points and shapes at full optimisation, where g++
/// 12 drops the rounding to float unless it is hidden from it: formula P22.

#include "02_primitives/bounding_circle/bounding_circle.hpp"

#include "tests/catch.hpp"

#include <random>
#include <vector>

using namespace cookbook;

TEMPLATE_TEST_CASE(
    "optimised, too, circles and rectangles hold all points: at 1e6 steps of 0.1, and anywhere",
    "[P22]", float, double)
{
  using Real = TestType;
  using Point = Vector<Real, 2>;
  std::mt19937 engine(9);
  int by_minimal = 0, by_centroid = 0, by_rectangle = 0, around_segment = 0;
  for (int i = 0; i < 20'000; ++i)
  {
    const double place = i % 2 == 0 ? 1e6 : 0, step = i % 4 == 0 ? 0.1 : std::ldexp(1, i % 20 - 10);
    std::vector<Point> points;
    for (int k = 0; k < 2 + i % 5; ++k)
    {
      const auto draw = [&] { return Real(place + step * (int(engine() % 5) - 2)); };
      const Real x = draw();
      points.push_back({x, draw()});
    }
    const Circle<Real> least = minimal_circle<Real>(points);
    const Circle<Real> centroid = centroid_circle<Real>(points);
    const Rectangle<Real> rectangle = bounding_rectangle<Real>(points);
    for (const Point& point : points)
    {
      by_minimal += contains(least, point) ? 0 : 1;
      by_centroid += contains(centroid, point) ? 0 : 1;
      by_rectangle += contains(rectangle, point) ? 0 : 1;
    }
    // Sums of floats are exact in double; in double itself the bounds of shapes are off by a
    // rounding.
    const Segment2<float> segment{
        points[0].template cast<float>(), points[1].template cast<float>()};
    for (const Vector<float, 2>& point : {segment.start, segment.end})
    {
      around_segment += contains(bounding_circle(segment), point) ? 0 : 1;
      around_segment += contains(bounding_rectangle(segment), point) ? 0 : 1;
    }
  }
  CHECK(by_minimal == 0);
  CHECK(by_centroid == 0);
  CHECK(by_rectangle == 0);
  CHECK(around_segment == 0);
}
