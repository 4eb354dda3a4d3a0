/// \file
/// What holds for the rays that ways to cast are timed with.

#include "02_primitives/cast_chart/trial/cast_chart.hpp"

#include "tests/catch.hpp"

using namespace cookbook;

// [cast_chart_workloads]
TEST_CASE(
    "balls up to 10 km away: as published is off by more than a part in 10,000, or misses", "[P9]")
{
  const auto casts = known_spheres(1000);
  const auto ours = [](const Ray<float>& ray, const Sphere<float>& ball)
  { return std::optional(cast(ray, ball).value().t); };
  CHECK(cast_errors<Sphere<float>>(ours, casts).maximum <= 0x1p-24);
  CHECK(cast_errors<Sphere<float>>(cast_in_float<Sphere<float>>, casts).p99 <= 1e-6);
  CHECK(cast_errors<Sphere<float>>(sphere_as_published, casts).maximum > 1e-4);
  CHECK(cast_errors<Sphere<float>>(sphere_quadratic, casts).maximum > 1e-4);
}

TEST_CASE("boxes that are aimed at: all ways are right to some roundings", "[P10]")
{
  const auto casts = known_boxes(1000);
  const auto ours = [](const Ray<float>& ray, const Aabb<float>& box)
  { return std::optional(cast(ray, box).value().t); };
  CHECK(cast_errors<Aabb<float>>(ours, casts).maximum <= 0x1p-24);
  CHECK(cast_errors<Aabb<float>>(cast_in_float<Aabb<float>>, casts).maximum <= 1e-6);
  CHECK(cast_errors<Aabb<float>>(box_by_inverse, casts).maximum <= 1e-6);
}

TEST_CASE("triangles that are aimed at: in double inside, t is the nearest float", "[P12]")
{
  const auto casts = known_triangles(500);
  const auto ours = [](const Ray<float>& ray, const Triangle<float>& triangle)
  { return std::optional(cast(ray, triangle).value().t); };
  CHECK(cast_errors<Triangle<float>>(ours, casts).maximum <= 0x1p-24);
  const auto taught = [](const Ray<float>& ray, const Triangle<float>& triangle)
  { return moller_trumbore(ray, triangle); };
  CHECK(cast_errors<Triangle<float>>(taught, casts).maximum > 1e-6);
}
// [cast_chart_workloads]
