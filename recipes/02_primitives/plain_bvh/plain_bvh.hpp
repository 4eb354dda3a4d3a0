#pragma once

/// \file
/// \brief A tree of boxes around the triangles of a mesh, cut in halves, and the ray that walks it.

#include "02_primitives/meshes/triangle_mesh.hpp"
#include "02_primitives/plain_casts/plain_casts.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

namespace cookbook
{

// [build_bvh]
/// A box around triangles: a leaf with their numbers, or two smaller boxes.
template <class Real>
struct BvhNode
{
  Aabb<Real> box;                           ///< [m], holds all below
  std::vector<int> triangles;               ///< of a leaf
  std::unique_ptr<BvhNode<Real>> low, high; ///< the children; null in a leaf
};

/// The tree around some triangles of a mesh, cut in halves along the longest side of each box.
template <class Real>
std::unique_ptr<BvhNode<Real>> build_bvh(const TriangleMesh<Real>& mesh, std::vector<int> some)
{
  auto node = std::make_unique<BvhNode<Real>>();
  for (const int i : some)
  {
    node->box.extend(box_of_triangle(mesh, i));
  }
  if (some.size() <= 4)
  {
    node->triangles = some;
    return node;
  }
  Eigen::Index axis = 0;
  node->box.sizes().maxCoeff(&axis);
  const auto before = [&](int i, int j)
  { return box_of_triangle(mesh, i).center()[axis] < box_of_triangle(mesh, j).center()[axis]; };
  const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
  std::nth_element(some.begin(), middle, some.end(), before);
  node->low = build_bvh(mesh, std::vector<int>(some.begin(), middle));
  node->high = build_bvh(mesh, std::vector<int>(middle, some.end()));
  return node;
}

/// The tree around all triangles of a mesh.
template <class Real>
std::unique_ptr<BvhNode<Real>> build_bvh(const TriangleMesh<Real>& mesh)
{
  std::vector<int> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  return build_bvh(mesh, all);
}
// [build_bvh]

// [cast_bvh]
/// The nearest t at which a ray meets a triangle of the tree, if it is less than `nearest`.
template <class Real>
std::optional<Real> cast_bvh(
    const Ray<Real>& ray, const TriangleMesh<Real>& mesh, const BvhNode<Real>& node,
    std::optional<Real> nearest = std::nullopt)
{
  const auto is_nearer = [&](const std::optional<Real>& t)
  { return t && (!nearest || *t < *nearest); };
  if (!is_nearer(ray_box(ray, node.box)))
  {
    return nearest; // nothing in the box can be nearer
  }
  for (const int i : node.triangles)
  {
    const std::optional<Real> t = ray_triangle(ray, triangle_of(mesh, i));
    nearest = is_nearer(t) ? t : nearest;
  }
  for (const BvhNode<Real>* child : {node.low.get(), node.high.get()})
  {
    nearest = child ? cast_bvh(ray, mesh, *child, nearest) : nearest;
  }
  return nearest;
}
// [cast_bvh]

} // namespace cookbook
