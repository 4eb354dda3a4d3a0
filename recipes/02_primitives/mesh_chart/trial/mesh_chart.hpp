#pragma once

/// \file
/// \brief Balls of triangles, rays that meet them, and points around them.

#include "02_primitives/mesh_chart/trial/mesh_peers.hpp"
#include "02_primitives/meshes/trial/mesh_scenes.hpp"
#include "02_primitives/meshes/trial/meshes_figures.hpp"

#include <vector>

namespace cookbook
{

// [mesh_workload]
/// A closed ball of radius 1, its tree, and what it is asked.
struct MeshWorkload
{
  TriangleMesh<float> mesh;
  BoundingVolumes<float> tree;
  std::vector<Ray<float>> rays;       ///< from outside to a point within; all meet it before t = 1
  std::vector<Vector3<float>> points; ///< in a cube of 4 m around it
};

/// The ball of 8 · 4^times triangles, and so many rays and points.
inline MeshWorkload mesh_workload(int times, int count)
{
  MeshWorkload work{mesh_as<float>(ball_mesh(times)), {}, {}, {}};
  work.tree = build_volumes(work.mesh);
  MeshDraw draw;
  for (int i = 0; i < count; ++i)
  {
    const Ray<double> ray = ray_at_ball(draw);
    work.rays.push_back({ray.origin.cast<float>(), ray.direction.cast<float>()});
    work.points.push_back(draw.point(2).cast<float>());
  }
  return work;
}
// [mesh_workload]

} // namespace cookbook
