#pragma once

/// \file
/// \brief A tree of boxes around the triangles of a mesh: built by surface area, refitted, walked.

#include "02_primitives/meshes/triangle_mesh.hpp"
#include "common/math/wide.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace cookbook
{

// [bounding_volumes]
/// A box of the tree.
template <class Real>
struct VolumeNode
{
  Eigen::AlignedBox<Real, 3> box; ///< [m], holds all below
  int first;                      ///< of a leaf: its first place in `order`; else its first child
  int count;                      ///< of a leaf: how many triangles; else 0
};

/// A tree of boxes, the root first; the second child stands behind the first, both behind their
/// parent. Empty for a mesh without triangles.
template <class Real>
struct BoundingVolumes
{
  std::vector<VolumeNode<Real>> nodes;
  std::vector<int> order; ///< numbers of triangles, those of a leaf side by side
};
// [bounding_volumes]

/// No leaf has more triangles.
inline constexpr int most_in_a_leaf = 4;
/// Into so many slices the centres are sorted, along each axis.
inline constexpr int volume_slices = 16;
/// Below this depth triangles are parted into halves, so that no tree is deeper than 80.
inline constexpr int deepest_by_area = 48;

/// Half the surface of a box [m²]; 0 for an empty one.
template <class Real>
Wide<Real> half_area(const Eigen::AlignedBox<Real, 3>& box)
{
  if (box.isEmpty())
  {
    return 0;
  }
  const Vector3<Wide<Real>> size = widen(box.max()) - widen(box.min());
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

/// The slice, from 0 to 15, in which the centre of a box lies along an axis of `around`.
template <class Real>
int slice_of(
    const Eigen::AlignedBox<Real, 3>& box, const Eigen::AlignedBox<Wide<Real>, 3>& around, int axis)
{
  using W = Wide<Real>;
  const W center = W(box.min()[axis]) / 2 + W(box.max()[axis]) / 2;
  const W low = around.min()[axis], high = around.max()[axis];
  const W fraction = high > low ? (center - low) / (high - low) : W(0);
  return std::min(static_cast<int>(fraction * volume_slices), volume_slices - 1);
}

// [cheapest_cut]
/// Where to part triangles: those in slices below `slice` along `axis` from the others.
template <class Real>
struct VolumeCut
{
  int axis = -1; ///< -1: nowhere
  int slice = 0;
  Wide<Real> cost = std::numeric_limits<Wide<Real>>::infinity();
};

/// The cut after which a ray has the least to do: each side costs its triangles, times the chance
/// that it is met, which is its surface.
template <class Real>
VolumeCut<Real> cheapest_cut(
    const std::vector<Eigen::AlignedBox<Real, 3>>& boxes, const int* first, const int* last,
    const Eigen::AlignedBox<Wide<Real>, 3>& centers)
{
  VolumeCut<Real> best;
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<Eigen::AlignedBox<Real, 3>, volume_slices> box;
    std::array<int, volume_slices> count{};
    for (const int* i = first; i != last; ++i)
    {
      const Eigen::AlignedBox<Real, 3>& one = boxes[static_cast<std::size_t>(*i)];
      const auto slice = static_cast<std::size_t>(slice_of(one, centers, axis));
      box[slice].extend(one);
      ++count[slice];
    }
    std::array<Wide<Real>, volume_slices> cost_above{};
    Eigen::AlignedBox<Real, 3> side;
    Wide<Real> number = 0;
    for (std::size_t slice = volume_slices - 1; slice > 0; --slice)
    {
      side.extend(box[slice]);
      cost_above[slice] = half_area(side) * (number += static_cast<Wide<Real>>(count[slice]));
    }
    side.setEmpty();
    number = 0;
    for (std::size_t slice = 1; slice < volume_slices; ++slice)
    {
      side.extend(box[slice - 1]);
      number += static_cast<Wide<Real>>(count[slice - 1]);
      const Wide<Real> cost = half_area(side) * number + cost_above[slice];
      const bool parts = number > 0 && number < static_cast<Wide<Real>>(last - first);
      if (parts && cost < best.cost)
      {
        best = {axis, static_cast<int>(slice), cost};
      }
    }
  }
  return best;
}
// [cheapest_cut]

// [grow_volumes]
/// Makes the node a leaf, or parts its triangles and grows both children.
template <class Real>
void grow_volumes(
    BoundingVolumes<Real>& tree, const std::vector<Eigen::AlignedBox<Real, 3>>& boxes,
    std::size_t node, int depth)
{
  int* const begin = tree.order.data() + tree.nodes[node].first;
  int* const end = begin + tree.nodes[node].count;
  Eigen::AlignedBox<Wide<Real>, 3> centers;
  for (const int* i = begin; i != end; ++i)
  {
    const Eigen::AlignedBox<Real, 3>& box = boxes[static_cast<std::size_t>(*i)];
    tree.nodes[node].box.extend(box);
    centers.extend(widen(box.min()) / 2 + widen(box.max()) / 2);
  }
  if (tree.nodes[node].count <= most_in_a_leaf)
  {
    return;
  }
  const VolumeCut<Real> cut =
      depth < deepest_by_area ? cheapest_cut(boxes, begin, end, centers) : VolumeCut<Real>{};
  const auto is_below = [&](int i)
  { return slice_of(boxes[static_cast<std::size_t>(i)], centers, cut.axis) < cut.slice; };
  // Where all centres are at one place, any halves will do.
  int* const middle =
      cut.axis < 0 ? begin + (end - begin) / 2 : std::partition(begin, end, is_below);
  const int first = tree.nodes[node].first, below = static_cast<int>(middle - begin);
  const int child = static_cast<int>(tree.nodes.size());
  tree.nodes.push_back({{}, first, below});
  tree.nodes.push_back({{}, first + below, tree.nodes[node].count - below});
  tree.nodes[node].first = child;
  tree.nodes[node].count = 0;
  grow_volumes(tree, boxes, static_cast<std::size_t>(child), depth + 1);
  grow_volumes(tree, boxes, static_cast<std::size_t>(child) + 1, depth + 1);
}
// [grow_volumes]

// [build_volumes]
/// A tree of boxes around the triangles of a mesh.
template <class Real>
BoundingVolumes<Real> build_volumes(const TriangleMesh<Real>& mesh)
{
  const int count = static_cast<int>(mesh.triangles.size());
  BoundingVolumes<Real> tree;
  tree.order.resize(mesh.triangles.size());
  std::iota(tree.order.begin(), tree.order.end(), 0);
  std::vector<Eigen::AlignedBox<Real, 3>> boxes;
  for (int i = 0; i < count; ++i)
  {
    boxes.push_back(box_of_triangle(mesh, i));
  }
  if (count > 0)
  {
    tree.nodes.push_back({{}, 0, count});
    grow_volumes(tree, boxes, 0, 0);
  }
  return tree;
}
// [build_volumes]

} // namespace cookbook
