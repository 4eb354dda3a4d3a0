/// \file
/// What holds for the meshes that are timed: all libraries find the same.

#include "02_primitives/mesh_chart/trial/mesh_chart.hpp"

#include "tests/catch.hpp"

#include <cmath>

using namespace cookbook;

// [mesh_chart_agree]
TEST_CASE("rays and closest points are those of other libraries, to a float's rounding", "[meshes]")
{
  const MeshWorkload work = mesh_workload(4, 500);
#ifdef COOKBOOK_HAS_EMBREE
  const EmbreeMesh embree(work.mesh);
#endif
#ifdef COOKBOOK_HAS_BULLET
  const BulletMesh bullet(work.mesh);
#endif
#ifdef COOKBOOK_HAS_FCL
  const FclMesh fcl(work.mesh);
#endif
#ifdef COOKBOOK_HAS_CGAL
  const CgalMesh cgal(work.mesh);
#endif
  for (const Ray<float>& ray : work.rays)
  {
    const auto ours = cast(ray, work.mesh, work.tree);
    REQUIRE(ours.has_value());
    CHECK(cast_without_tree(ray, work.mesh)->second == ours->triangle);
#ifdef COOKBOOK_HAS_EMBREE
    CHECK(std::abs(embree.cast(ray).value_or(9) - ours->hit.t) < 1e-5f);
#endif
#ifdef COOKBOOK_HAS_BULLET
    CHECK(std::abs(bullet.cast(ray).value_or(9) - ours->hit.t) < 1e-5f);
#endif
#ifdef COOKBOOK_HAS_FCL
    CHECK(fcl.is_met(ray));
#endif
#ifdef COOKBOOK_HAS_CGAL
    CHECK(cgal.cast(ray) == ours->triangle);
#endif
  }
  for (const Vector3<float>& point : work.points)
  {
    const double ours{closest_point_of_mesh(work.mesh, work.tree, point)->distance};
    CHECK(std::abs(closest_without_tree(work.mesh, point).first - ours) < 1e-5);
#ifdef COOKBOOK_HAS_FCL
    CHECK(std::abs(fcl.distance(point) - ours) < 1e-5);
#endif
#ifdef COOKBOOK_HAS_CGAL
    CHECK(std::abs(cgal.distance(point) - ours) < 1e-5);
#endif
  }
}
// [mesh_chart_agree]

// [mesh_growth]
TEST_CASE("four times the triangles cost a ray at most seven more boxes", "[meshes]")
{
  const int rays = 2000;
  double before = 1e9;
  for (const int times : {3, 4, 5, 6, 7})
  {
    const auto boxes = static_cast<double>(asked_in_all(ball_mesh(times), rays).boxes) / rays;
    CHECK(boxes < before + 7);
    before = boxes;
  }
}
// [mesh_growth]
