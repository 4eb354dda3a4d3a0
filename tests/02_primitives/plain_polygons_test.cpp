/// \file
/// What holds for the separating axis test of two convex polygons, and where it ends.

#include "02_primitives/bounding_circle/bounding_circle.hpp"
#include "02_primitives/in_the_plane/in_the_plane.hpp"
#include "02_primitives/plain_polygons/plain_polygons.hpp"

#include "tests/catch.hpp"

#include <random>
#include <span>

using namespace cookbook;

// [polygons_by_hand]
TEST_CASE("a slanted edge separates 2x + y = 6 from (2, 1.5), and not from (2, 2)", "[plain]")
{
  const Polygon<double> ramp{{3, 0}, {3, 4}, {1, 4}};
  CHECK(polygons_overlap({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, ramp)); // they touch
  CHECK_FALSE(polygons_overlap({{0, 0}, {2, 0}, {2, 1.5}, {0, 1.5}}, ramp));
}
// [polygons_by_hand]

// [segments_in_line]
TEST_CASE(
    "two segments in line, 1 apart, overlap by edges alone, and are apart by x and y", "[plain]")
{
  const Polygon<double> one{{0, 0}, {1, 0}}, other{{2, 0}, {3, 0}};
  CHECK(polygons_overlap(one, other)); // wrong
  using Span = std::span<const Vector2<double>>;
  CHECK_FALSE(overlaps<double>(Span(one), Span(other)));
}
// [segments_in_line]

TEST_CASE(
    "10,000 pairs of triangles on a grid: plain and hardened agree wherever both have an area",
    "[plain]")
{
  std::mt19937 random(2);
  const auto corner = [&]() -> Vector2<double> {
    return {double(random() % 8), double(random() % 8)};
  };
  const auto area = [](const Polygon<double>& p)
  {
    const Vector2<double> u = p[1] - p[0], v = p[2] - p[0];
    return u.x() * v.y() - u.y() * v.x();
  };
  int different = 0;
  for (int i = 0; i < 10'000; ++i)
  {
    const Polygon<double> a{corner(), corner(), corner()}, b{corner(), corner(), corner()};
    using Span = std::span<const Vector2<double>>;
    const bool both = area(a) != 0 && area(b) != 0;
    different += both && polygons_overlap(a, b) != overlaps<double>(Span(a), Span(b)) ? 1 : 0;
  }
  CHECK(different == 0);
}

// [mean_circle]
TEST_CASE(
    "the circle about the mean of 12 x 16 corners has radius 10, and is the smallest", "[P22]")
{
  const std::vector<Vector2<double>> corners{{0, 0}, {12, 0}, {12, 16}, {0, 16}};
  const Circle<double> circle = mean_circle(corners);
  CHECK((circle.center == Vector2<double>(6, 8) && circle.radius == 10));
}

TEST_CASE(
    "of 1,000 plain float circles some leave a point out by rounding, of centroid_circle none",
    "[P22]")
{
  std::mt19937 random(8);
  const auto draw = [&] { return float(random() % 65536) / 6553.6f; };
  int out = 0, out_of_hardened = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const std::vector<Vector2<float>> points{{draw(), draw()}, {draw(), draw()}, {draw(), draw()}};
    const Circle<float> plain = mean_circle(points);
    const Circle<float> hardened = centroid_circle<float>(std::span<const Vector2<float>>(points));
    for (const Vector2<float>& p : points)
    {
      out += contains(plain, p) ? 0 : 1;
      out_of_hardened += contains(hardened, p) ? 0 : 1;
    }
  }
  CHECK(out > 100);
  CHECK(out_of_hardened == 0);
}
// [mean_circle]
