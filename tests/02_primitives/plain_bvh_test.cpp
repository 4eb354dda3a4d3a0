/// \file
/// What holds for a plain tree of boxes, and the two cases that it fails.

#include "02_primitives/meshes/meshes.hpp"
#include "02_primitives/plain_bvh/plain_bvh.hpp"

#include "tests/catch.hpp"

#include <random>

using namespace cookbook;

namespace
{

/// A ground of `size` × `size` squares of a metre, of two triangles each.
TriangleMesh<double> ground_of(int size)
{
  TriangleMesh<double> ground;
  for (int x = 0; x <= size; ++x)
  {
    for (int z = 0; z <= size; ++z)
    {
      ground.vertices.push_back({double(x), 0, double(z)});
    }
  }
  for (int x = 0; x < size; ++x)
  {
    for (int z = 0; z < size; ++z)
    {
      const int a = x * (size + 1) + z, b = a + size + 1;
      ground.triangles.push_back({a, a + 1, b});
      ground.triangles.push_back({b, a + 1, b + 1});
    }
  }
  return ground;
}

} // namespace

// [plain_bvh]
TEST_CASE("10,000 rays at 500 triangles: the tree finds the t of asking all of them", "[plain]")
{
  std::mt19937 random(7);
  const auto draw = [&] { return double(random()) * 0x1p-31 - 1; };
  TriangleMesh<double> mesh;
  for (int i = 0; i < 1500; ++i)
  {
    mesh.vertices.push_back({draw(), draw(), draw()});
  }
  for (int i = 0; i < 1500; i += 3)
  {
    mesh.triangles.push_back({i, i + 1, i + 2});
  }
  const auto bvh = build_bvh(mesh);
  int different = 0;
  for (int i = 0; i < 10'000; ++i)
  {
    const Ray<double> ray{{3 * draw(), 3 * draw(), 3 * draw()}, {draw(), draw(), draw()}};
    std::optional<double> nearest;
    for (int triangle = 0; triangle < 500; ++triangle)
    {
      const auto t = ray_triangle(ray, triangle_of(mesh, triangle));
      nearest = t && (!nearest || *t < *nearest) ? t : nearest;
    }
    different += cast_bvh(ray, mesh, *bvh) == nearest ? 0 : 1;
  }
  CHECK(different == 0);
}
// [plain_bvh]

// [plain_bvh_fails]
TEST_CASE(
    "straight down at the line between two boxes of the tree: the plain one loses the ground",
    "[plain]")
{
  const TriangleMesh<double> ground = ground_of(8);
  const Ray<double> down{{4, 5, 0.5}, {0, -1, 0}};
  CHECK(ray_triangle(down, triangle_of(ground, 64))); // met, if it is asked
  CHECK_FALSE(cast_bvh(down, ground, *build_bvh(ground)));
  CHECK(cast(down, ground, build_volumes(ground))->hit.t == 5);
}
// [plain_bvh_fails]
