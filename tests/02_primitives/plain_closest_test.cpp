/// \file
/// What holds for the closest points of a triangle and of two segments, as the formulas stand, and
/// where it ends.

#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/plain_closest/plain_closest.hpp"

#include "tests/catch.hpp"

#include <random>

using namespace cookbook;

// [plain_triangle]
TEST_CASE("over the face, beside an edge and at a corner of (0,0)-(4,0)-(0,4)", "[P11][P13]")
{
  using V = Vector3<double>;
  const Triangle<double> roof{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  CHECK(barycentric(roof, {1, 2, 9}) == V(0.25, 0.25, 0.5));
  CHECK(closest_on_triangle(roof, {1, 1, 3}) == V(1, 1, 0));
  CHECK(closest_on_triangle(roof, {3, 3, 1}) == V(2, 2, 0));
  CHECK(closest_on_triangle(roof, {7, -1, 2}) == V(4, 0, 0));
}
// [plain_triangle]

// [plain_segments]
TEST_CASE("two segments that cross 3 apart, two that are parallel, and end against side", "[P14]")
{
  using V = Vector3<double>;
  const Segment<double> beam{{-2, 0, 0}, {2, 0, 0}};
  const ClosestPoints<double, 3> cross = closest_on_segments(beam, {{1, 3, -2}, {1, 3, 2}});
  CHECK((cross.a == V(1, 0, 0) && cross.b == V(1, 3, 0) && cross.distance == 3));
  CHECK(closest_on_segments(beam, {{1, 4, 0}, {9, 4, 0}}).distance == 4);
  CHECK(closest_on_segments(beam, {{5, 4, 0}, {9, 4, 0}}).distance == 5); // by 3-4-5
  CHECK(closest_on_segments(beam, {{0, 2, 0}, {0, 5, 7}}).distance == 2);
}
// [plain_segments]

TEST_CASE(
    "20,000 segments and triangles in a room: plain and hardened distances agree to 1e-11",
    "[P13][P14]")
{
  std::mt19937 random(3);
  const auto draw = [&] { return double(random()) * 0x1p-31 - 1; };
  const auto point = [&]() -> Vector3<double> {
    return {draw(), draw(), draw()};
  };
  double worst = 0;
  for (int i = 0; i < 20'000; ++i)
  {
    const Segment<double> a{point(), point()}, b{point(), point()};
    const Triangle<double> triangle{point(), point(), point()};
    const Vector3<double> p = point();
    const double to_triangle = (closest_on_triangle(triangle, p) - p).norm();
    worst = std::max(
        {worst, std::abs(closest_on_segments(a, b).distance - closest_points(a, b).distance),
         std::abs(to_triangle - closest_points(p, triangle).distance)});
  }
  CHECK(worst <= 1e-11);
}

// [sticks_at_10_km]
TEST_CASE(
    "float sticks 1 mm apart, 10 km from the origin: plain is off by a tenth, closest_points right",
    "[P14]")
{
  const Vector3<float> there(10'000, 10'000, 10'000);
  const float gap = 1.0f / 1024; // one step from a float to the next, at 10 km
  const Segment<float> a{there, there + Vector3<float>(2.7f, 1.1f, 0)};
  const Segment<float> b{there + Vector3<float>(1, 1, gap), there + Vector3<float>(2, 0, gap)};
  CHECK(std::abs(closest_on_segments(a, b).distance - gap) >= gap / 10);
  CHECK(std::abs(closest_points(a, b).distance - gap) <= gap / 1'000'000);
}
// [sticks_at_10_km]
