#pragma once

/// \file
/// \brief What a mesh is asked: the nearest hit of a ray, the closest point, and which triangles
/// are near a sphere or a box.

#include "02_primitives/meshes/bounding_volumes.hpp"
#include "02_primitives/meshes/ray_enters_box.hpp"
#include "02_primitives/meshes/ray_triangle_watertight.hpp"
#include "02_primitives/meshes/triangle_closest.hpp"
#include "02_primitives/meshes/triangle_mesh.hpp"
#include "02_primitives/meshes/walk_volumes.hpp"
#include "02_primitives/shapes/answers.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace cookbook
{

// [cast_mesh]
/// Where a ray first meets a mesh, and which of its triangles.
template <class Real>
struct MeshHit
{
  Hit<Real, 3> hit; ///< the normal is on the side that the ray comes from
  int triangle;     ///< its number; the least, where several are met at the same t
};

/// The nearest hit of a ray; nothing if it has no direction, or passes by. The tree must be that of
/// the mesh. A closed mesh has no gaps.
template <class Real>
[[gnu::flatten]] std::optional<MeshHit<Real>>
cast(const Ray<Real>& ray, const TriangleMesh<Real>& mesh, const BoundingVolumes<Real>& tree)
{
  using W = Wide<Real>;
  W nearest = std::numeric_limits<W>::infinity();
  int met = -1;
  if (tree.nodes.empty() || ray.direction.isZero(0))
  {
    return std::nullopt;
  }
  const ShearedView<W> view = view_along(ray);
  const RayForBoxes<Real> for_boxes = ray_for_boxes(ray, tree.nodes[0].box);
  walk_volumes(
      tree, [&](const Eigen::AlignedBox<Real, 3>& box) { return ray_enters_box(for_boxes, box); },
      [&] { return nearest * std::abs(view.along_z); },
      [&](int triangle)
      {
        const std::optional<W> t = ray_triangle_watertight(view, triangle_of(mesh, triangle));
        if (t && (*t < nearest || (*t == nearest && triangle < met)))
        {
          nearest = *t;
          met = triangle;
        }
      });
  if (met < 0)
  {
    return std::nullopt;
  }
  const Vector3<W> point = widen(ray.origin) + nearest * widen(ray.direction);
  const Vector3<Real> normal = normal_towards(triangle_of(mesh, met), ray.direction);
  return MeshHit<Real>{{static_cast<Real>(nearest), point.template cast<Real>(), normal}, met};
}
// [cast_mesh]

// [box_distance]
/// How far a point is from a box of the tree, 0 inside.
template <class Real>
Wide<Real> box_distance(const Eigen::AlignedBox<Real, 3>& box, const Vector3<Real>& point)
{
  const Vector3<Wide<Real>> p = widen(point);
  const Vector3<Wide<Real>> away = (widen(box.min()) - p).cwiseMax(p - widen(box.max()));
  return away.cwiseMax(Vector3<Wide<Real>>::Zero()).norm();
}
// [box_distance]

// [closest_point_mesh]
/// The point of a mesh that is closest to a point, and its triangle.
template <class Real>
struct MeshPoint
{
  Vector3<Real> point; ///< [m], world
  Real distance;       ///< [m]
  int triangle;        ///< its number; the least, where several are as close
};

/// The closest point of a mesh; nothing if it has no triangles. The tree must be that of the mesh.
template <class Real>
[[gnu::flatten]] std::optional<MeshPoint<Real>> closest_point_of_mesh(
    const TriangleMesh<Real>& mesh, const BoundingVolumes<Real>& tree, const Vector3<Real>& point)
{
  const Vector3<Wide<Real>> p = widen(point);
  Wide<Real> nearest = std::numeric_limits<Wide<Real>>::infinity();
  int closest = -1;
  const Wide<Real> little =
      tree.nodes.empty() ? 0 : walk_rounding<Wide<Real>>(tree.nodes[0].box, point);
  walk_volumes(
      tree,
      [&](const Eigen::AlignedBox<Real, 3>& box) { return box_distance(box, point) - little; },
      [&] { return nearest; },
      [&](int triangle)
      {
        const Wide<Real> distance = vector_to_triangle<Real>(triangle_of(mesh, triangle), p).norm();
        if (distance < nearest || (distance == nearest && triangle < closest))
        {
          nearest = distance;
          closest = triangle;
        }
      });
  if (closest < 0)
  {
    return std::nullopt;
  }
  const Vector3<Real> there = closest_point_of_triangle(triangle_of(mesh, closest), point);
  return MeshPoint<Real>{there, static_cast<Real>(nearest), closest};
}
// [closest_point_mesh]

// [triangles_touching]
/// The numbers of all triangles that touch a sphere, in their order.
template <class Real>
std::vector<int> triangles_touching(
    const TriangleMesh<Real>& mesh, const BoundingVolumes<Real>& tree, const Sphere<Real>& sphere)
{
  using V = Vector3<Wide<Real>>;
  const V p = widen(sphere.center);
  const Wide<Real> radius = sphere.radius;
  std::vector<int> touching;
  const Wide<Real> little =
      tree.nodes.empty() ? 0 : walk_rounding<Wide<Real>>(tree.nodes[0].box, sphere.center);
  walk_volumes(
      tree,
      [&](const Eigen::AlignedBox<Real, 3>& box)
      { return box_distance(box, sphere.center) - little; },
      [&] { return radius; },
      [&](int triangle)
      {
        if (vector_to_triangle<Real>(triangle_of(mesh, triangle), p).norm() <= radius)
        {
          touching.push_back(triangle);
        }
      });
  std::sort(touching.begin(), touching.end());
  return touching;
}

/// The numbers of all triangles whose own boxes touch a box, in their order: those that may touch
/// it.
template <class Real>
std::vector<int> triangles_near(
    const TriangleMesh<Real>& mesh, const BoundingVolumes<Real>& tree,
    const Eigen::AlignedBox<Real, 3>& box)
{
  using W = Wide<Real>;
  std::vector<int> found;
  walk_volumes(
      tree,
      [&](const Eigen::AlignedBox<Real, 3>& other)
      { return box.intersects(other) ? W(0) : std::numeric_limits<W>::infinity(); },
      [] { return W(0); },
      [&](int triangle)
      {
        if (box.intersects(box_of_triangle(mesh, triangle)))
        {
          found.push_back(triangle);
        }
      });
  std::sort(found.begin(), found.end());
  return found;
}
// [triangles_touching]

} // namespace cookbook
