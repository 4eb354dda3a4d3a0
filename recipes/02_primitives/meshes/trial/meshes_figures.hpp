#pragma once

/// \file
/// \brief How many boxes a ray asks, and the figure of a tree that a ray goes through.

#include "02_primitives/meshes/meshes.hpp"
#include "02_primitives/meshes/trial/mesh_scenes.hpp"
#include "tools/plot/figures/figure2d.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook
{

/// What a ray asked on its way.
struct Asked
{
  std::size_t boxes = 0;     ///< how often a box was asked
  std::size_t triangles = 0; ///< and a triangle
};

/// Casts a ray as `cast` does and counts.
inline Asked asked_by(
    const Ray<double>& ray, const TriangleMesh<double>& mesh, const BoundingVolumes<double>& tree)
{
  Asked asked;
  double nearest = std::numeric_limits<double>::infinity();
  const ShearedView<double> view = view_along(ray);
  const RayForBoxes<double> for_boxes = ray_for_boxes(ray, tree.nodes[0].box);
  walk_volumes(
      tree,
      [&](const Eigen::AlignedBox<double, 3>& box)
      {
        ++asked.boxes;
        return ray_enters_box(for_boxes, box);
      },
      [&] { return nearest * std::abs(view.along_z); },
      [&](int triangle)
      {
        ++asked.triangles;
        const auto t = ray_triangle_watertight(view, triangle_of(mesh, triangle));
        nearest = t && *t < nearest ? *t : nearest;
      });
  return asked;
}

/// A ray from outside of the ball to a point inside of it.
inline Ray<double> ray_at_ball(MeshDraw& draw)
{
  const Vector3<double> from = 3 * draw.point(1) + Vector3<double>(4, 0, 0);
  return {from, draw.point(0.5) - from};
}

/// A ray's mean over many rays.
inline Asked asked_in_all(const TriangleMesh<double>& mesh, int rays)
{
  MeshDraw draw;
  Asked all;
  const BoundingVolumes<double> tree = build_volumes(mesh);
  for (int i = 0; i < rays; ++i)
  {
    const Asked one = asked_by(ray_at_ball(draw), mesh, tree);
    all.boxes += one.boxes;
    all.triangles += one.triangles;
  }
  return all;
}

/// Small triangles in a plane, in three heaps.
inline TriangleMesh<double> flat_heaps()
{
  MeshDraw draw;
  TriangleMesh<double> mesh;
  for (const Vector3<double>& heap :
       {Vector3<double>(1, 0.8, 0), Vector3<double>(4.4, 2.8, 0), Vector3<double>(8, 1.2, 0)})
  {
    for (int i = 0; i < 8; ++i)
    {
      const double x = draw(-0.9, 0.9), y = draw(-0.8, 0.8), angle = draw(0, 6);
      const Vector3<double> at = heap + Vector3<double>(x, y, 0);
      const int first = static_cast<int>(mesh.vertices.size());
      for (const double turn : {0.0, 2.1, 4.2})
      {
        const Vector3<double> out(std::cos(angle + turn), std::sin(angle + turn), 0);
        mesh.vertices.push_back(at + 0.22 * out);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return mesh;
}

/// A tree of boxes around triangles in a plane, and a ray: what it enters is drawn in orange.
inline plot::Figure2d tree_figure()
{
  const TriangleMesh<double> mesh = flat_heaps();
  const BoundingVolumes<double> tree = build_volumes(mesh);
  const Ray<double> ray{{-0.7, 1.1, 0}, {10, 0.75, 0}};
  const RayForBoxes<double> for_boxes = ray_for_boxes(ray, tree.nodes[0].box);
  plot::Figure2d figure("meshes", "", {{-0.9, -0.4}, {9.7, 4}, 460});
  figure.describe("Triangles in three heaps, boxes in boxes around them, and a ray across.");
  for (int i = 0; i < static_cast<int>(mesh.triangles.size()); ++i)
  {
    const Triangle<double> t = triangle_of(mesh, i);
    figure.polygon({t.a.head<2>(), t.b.head<2>(), t.c.head<2>()}, plot::Ink::a);
  }
  for (const bool entered : {false, true})
  {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
    {
      const Eigen::AlignedBox<double, 3>& box = tree.nodes[i].box;
      const double grow = tree.nodes[i].count > 0 ? 0.02 : 0.06;
      if (std::isfinite(ray_enters_box(for_boxes, box)) == entered)
      {
        const Eigen::Vector2d half = box.sizes().head<2>() / 2 + Eigen::Vector2d(grow, grow);
        figure.box(
            box.center().head<2>(), 0, half, entered ? plot::Ink::b : plot::Ink::muted,
            plot::Fill::none, entered ? plot::Stroke::solid : plot::Stroke::dashed);
      }
    }
  }
  figure.arrow(ray.origin.head<2>(), (ray.origin + ray.direction).head<2>(), plot::Ink::ink)
      .label(ray.origin.head<2>(), "ray", plot::Side::above);
  return figure;
}

} // namespace cookbook
