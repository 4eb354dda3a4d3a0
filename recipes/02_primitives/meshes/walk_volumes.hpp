#pragma once

/// \file
/// \brief A tree of boxes fitted again to a mesh that has moved, and walked from the near to the
/// far.

#include "02_primitives/meshes/bounding_volumes.hpp"

#include <array>
#include <limits>

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
/// What rounding may make of places inside of `whole` [m], seen from a point: 16 roundings of the
/// greatest distance along an axis.
template <class Real>
Wide<Real> walk_rounding(const Eigen::AlignedBox<Real, 3>& whole, const Vector3<Real>& point)
{
  using V = Vector3<Wide<Real>>;
  const V low = widen(whole.min()) - widen(point), high = widen(whole.max()) - widen(point);
  const Wide<Real> far = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff();
  return 16 * std::numeric_limits<Wide<Real>>::epsilon() * far;
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
  const auto push = [&](std::size_t node, W far)
  {
    if (far < std::numeric_limits<W>::infinity() && far <= bound())
    {
      stack[waiting++] = {node, far};
    }
  };
  if (!tree.nodes.empty())
  {
    push(0, key(tree.nodes[0].box));
  }
  while (waiting > 0)
  {
    const Waiting next = stack[--waiting];
    const VolumeNode<Real>& node = tree.nodes[next.node];
    const auto first = static_cast<std::size_t>(node.first);
    if (!(next.key <= bound()))
    {
      continue;
    }
    for (std::size_t i = first; i < first + static_cast<std::size_t>(node.count); ++i)
    {
      visit(tree.order[i]);
    }
    if (node.count == 0)
    {
      const W one = key(tree.nodes[first].box), other = key(tree.nodes[first + 1].box);
      push(one < other ? first + 1 : first, one < other ? other : one);
      push(one < other ? first : first + 1, one < other ? one : other);
    }
  }
}
// [walk_volumes]

} // namespace cookbook
