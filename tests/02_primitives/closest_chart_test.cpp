/// \file
/// What holds for the closest points that are timed.

#include "02_primitives/closest_chart/trial/closest_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [closest_chart_errors]
TEST_CASE("distances: ours are the nearest float; five dot products are not", "[P13][P14]")
{
  const auto triangles = known_triangles_and_points(1000);
  const auto segments = known_segments(1000);
  const double half_step = 0x1p-23; // of a float below 4 m
  const auto to_triangle = [](const Vector3<float>& p, const Triangle<float>& t)
  { return closest_points(p, t).distance; };
  const auto to_segment = [](const Segment<float>& a, const Segment<float>& b)
  { return closest_points(a, b).distance; };
  CHECK(distance_errors(to_triangle, triangles).maximum <= half_step);
  CHECK(distance_errors(to_segment, segments).maximum <= half_step);
  CHECK(distance_errors(distance_in_float, triangles).maximum <= 2 * half_step);
  CHECK(distance_errors(distance_by_dot_products, segments).maximum > 100 * half_step);
}
// [closest_chart_errors]
