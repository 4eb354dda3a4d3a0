#pragma once

/// \file
/// \brief A tree of boxes fitted again to a mesh that has moved, and walked from the near to the
/// far.

#include "02_primitives/meshes/bounding_volumes.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace cookbook
{

// [refit]
/// The same tree with its boxes around where the triangles are now, after corners have moved.
template <class Real>
BoundingVolumes<Real> refitted(BoundingVolumes<Real> tree, const TriangleMesh<Real>& mesh)
{
  // Children stand behind their parent: from the last to the first, each box finds its parts ready.
  for (std::size_t i = tree.nodes.size(); i-- > 0;)
  {
    VolumeNode<Real>& node = tree.nodes[i];
    const auto first = static_cast<std::size_t>(node.first);
    node.box.setEmpty();
    for (std::size_t k = first; k < first + static_cast<std::size_t>(node.count); ++k)
    {
      node.box.extend(box_of_triangle(mesh, tree.order[k]));
    }
    if (node.count == 0)
    {
      node.box = tree.nodes[first].box.merged(tree.nodes[first + 1].box);
    }
  }
  return tree;
}
// [refit]

// [walk_rounding]
/// What rounding in the number type W may make of places inside of `whole` [m], seen from a point:
/// 16 roundings of the greatest distance along an axis.
template <class W, class Real>
W walk_rounding(const Eigen::AlignedBox<Real, 3>& whole, const Vector3<Real>& point)
{
  const Vector3<W> low = whole.min().template cast<W>() - point.template cast<W>();
  const Vector3<W> high = whole.max().template cast<W>() - point.template cast<W>();
  const W largest = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
  using Limits = std::numeric_limits<W>;
  return W(16) * std::max(Limits::epsilon() * largest, Limits::denorm_min());
}
// [walk_rounding]

// [walk_volumes]
/// Visits the triangles of all leaves that may matter, the nearer child first.
///
/// `key(box)` says how far a box is, infinite: not to be visited at all. `bound()` is how far it
/// still matters; it may shrink while triangles are visited.
template <class Real, class Key, class Bound, class Visit>
void walk_volumes(const BoundingVolumes<Real>& tree, Key key, Bound bound, Visit visit)
{
  using W = Wide<Real>;
  struct Waiting
  {
    std::size_t node;
    W key;
  };
  std::array<Waiting, 96> stack;
  std::size_t waiting = 0;
  const auto matters = [&](W least)
  { return least < std::numeric_limits<W>::infinity() && least <= bound(); };
  if (tree.nodes.empty() || !matters(key(tree.nodes[0].box)))
  {
    return;
  }
  for (std::size_t here = 0;;)
  {
    const VolumeNode<Real>& node = tree.nodes[here];
    const auto first = static_cast<std::size_t>(node.first);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(node.count); ++i)
    {
      visit(tree.order[i]);
    }
    if (node.count == 0)
    {
      Waiting closer{first, key(tree.nodes[first].box)};
      Waiting farther{first + 1, key(tree.nodes[first + 1].box)};
      if (farther.key < closer.key)
      {
        std::swap(closer, farther);
      }
      if (matters(farther.key))
      {
        stack[waiting++] = farther;
      }
      if (matters(closer.key))
      {
        here = closer.node;
        continue;
      }
    }
    do
    {
      if (waiting == 0)
      {
        return;
      }
    } while (!(stack[--waiting].key <= bound()));
    here = stack[waiting].node;
  }
}
// [walk_volumes]

} // namespace cookbook
