#pragma once

/// \file
/// \brief All pairs of leaves of a tree that overlap.

#include "06_world/contacts/bounds_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace cookbook
{

/// A box wider by a fraction of its smallest size on all sides.
inline Eigen::AlignedBox<double, 3>
fattened(const Eigen::AlignedBox<double, 3>& box, double fraction)
{
  const Vector3<double> more = Vector3<double>::Constant(fraction * box.sizes().minCoeff());
  return {box.min() - more, box.max() + more};
}

// [each_overlap]
/// What Eigen's `intersects` says: whether two boxes overlap or touch. All axes are asked at once,
/// for a branch costs more than they do.
inline bool
boxes_intersect(const Eigen::AlignedBox<double, 3>& a, const Eigen::AlignedBox<double, 3>& b)
{
  bool along_all = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    along_all &= a.min()[axis] <= b.max()[axis];
    along_all &= b.min()[axis] <= a.max()[axis];
  }
  return along_all;
}

/// Calls `visit(body)` for all bodies below a node of a tree whose bounds `enters(box)` says may
/// matter, and those of all branches above them.
template <class Enters, class Visit>
void each_below(const BoundsTree& tree, std::size_t node, const Enters& enters, const Visit& visit)
{
  const BoundsTree::Node& here = tree.nodes()[node];
  if (!enters(here.box))
  {
    return;
  }
  if (here.right > 0)
  {
    each_below(tree, node + 1, enters, visit);
    return each_below(tree, here.right, enters, visit);
  }
  for (const Bounds& leaf : tree.leaves().subspan(here.first, here.end - here.first))
  {
    if (enters(leaf.box))
    {
      visit(leaf.body);
    }
  }
}

/// The same for all bodies of a tree; what is endless is always visited.
template <class Enters, class Visit>
void each_that(const BoundsTree& tree, const Enters& enters, const Visit& visit)
{
  for (const Bounds& one : tree.unbounded())
  {
    visit(one.body);
  }
  if (!tree.nodes().empty())
  {
    each_below(tree, 0, enters, visit);
  }
}

/// Asks all pairs of leaves of which one is below one node of a tree and one below another.
template <class Ask>
void overlaps_between(const BoundsTree& tree, std::size_t a, std::size_t b, const Ask& ask)
{
  const BoundsTree::Node &of_a = tree.nodes()[a], &of_b = tree.nodes()[b];
  if (!boxes_intersect(of_a.box, of_b.box))
  {
    return;
  }
  const bool a_is_larger = of_a.end - of_a.first >= of_b.end - of_b.first;
  if (of_a.right > 0 && (a_is_larger || of_b.right == 0))
  {
    overlaps_between(tree, a + 1, b, ask);
    return overlaps_between(tree, of_a.right, b, ask);
  }
  if (of_b.right > 0)
  {
    overlaps_between(tree, a, b + 1, ask);
    return overlaps_between(tree, a, of_b.right, ask);
  }
  for (std::size_t i = of_a.first; i < of_a.end; ++i)
  {
    const bool near_any = boxes_intersect(tree.leaves()[i].box, of_b.box);
    for (std::size_t j = of_b.first; j < of_b.end && near_any; ++j)
    {
      ask(tree.leaves()[i], tree.leaves()[j]);
    }
  }
}

/// Asks all pairs of leaves below a node of a tree.
template <class Ask>
void overlaps_below(const BoundsTree& tree, std::size_t node, const Ask& ask)
{
  const BoundsTree::Node& here = tree.nodes()[node];
  if (here.right > 0)
  {
    overlaps_below(tree, node + 1, ask);
    overlaps_below(tree, here.right, ask);
    return overlaps_between(tree, node + 1, here.right, ask);
  }
  for (std::size_t i = here.first; i < here.end; ++i)
  {
    for (std::size_t j = i + 1; j < here.end; ++j)
    {
      ask(tree.leaves()[i], tree.leaves()[j]);
    }
  }
}

/// Calls `meet(i, j)` once for all pairs of bodies whose bounds overlap, the smaller number first.
template <class Meet>
void each_overlap(const BoundsTree& tree, const Meet& meet)
{
  const auto ask = [&](const Bounds& a, const Bounds& b)
  {
    if (boxes_intersect(a.box, b.box))
    {
      meet(std::min(a.body, b.body), std::max(a.body, b.body));
    }
  };
  for (auto one = tree.unbounded().begin(); one != tree.unbounded().end(); ++one)
  {
    const auto with = [&](const Bounds& other) { ask(*one, other); };
    std::for_each(one + 1, tree.unbounded().end(), with);
    std::for_each(tree.leaves().begin(), tree.leaves().end(), with);
  }
  if (!tree.nodes().empty())
  {
    overlaps_below(tree, 0, ask);
  }
}

/// Adds the pairs of a leaf with all whose bounds overlap its own, the smaller number first.
inline void
add_overlaps(const BoundsTree& tree, std::size_t leaf, std::vector<std::pair<int, int>>& pairs)
{
  const Bounds& one = tree.all()[leaf];
  const auto meet = [&](int other)
  {
    if (other != one.body)
    {
      pairs.emplace_back(std::minmax(one.body, other));
    }
  };
  each_that(
      tree, [&](const auto& box) { return boxes_intersect(box, one.box); }, meet);
}
// [each_overlap]

} // namespace cookbook
