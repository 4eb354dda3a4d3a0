#pragma once

/// \file
/// \brief A tree of bounds, built anew in each step in n log n, however they lie.

#include "common/math/vector.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [bounds]
/// A body's bounds in the world.
struct Bounds
{
  Eigen::AlignedBox<double, 3> box; ///< [m], world; infinite for a plane
  int body;                         ///< its number
};
// [bounds]

// [bounds_tree]
/// Bounds in a binary tree: each node holds all below it, and has half of them on either side.
///
/// What is infinite, such as a plane, is kept apart. The room stays from step to step.
class BoundsTree
{
public:
  /// A branch of the tree.
  struct Node
  {
    Eigen::AlignedBox<double, 3> box; ///< [m], holds all below
    std::size_t first, end;           ///< of its leaves
    std::size_t right;                ///< its second child; the first stands behind it; 0: none
  };

  const std::vector<Node>& nodes() const { return nodes_; }       ///< the root first
  const std::vector<Bounds>& leaves() const { return leaves_; }   ///< all that is finite
  const std::vector<Bounds>& endless() const { return endless_; } ///< all else

  /// Sorts bounds into the tree.
  void build(std::span<const Bounds> bounds)
  {
    leaves_.clear();
    endless_.clear();
    nodes_.clear();
    for (const Bounds& one : bounds)
    {
      const bool finite = one.box.min().allFinite() && one.box.max().allFinite();
      (finite ? leaves_ : endless_).push_back(one);
    }
    if (!leaves_.empty())
    {
      grow(0, leaves_.size());
    }
  }

  /// Calls `visit(body)` for all bodies whose bounds `enters(box)` says may matter, and those of
  /// all branches above them.
  template <class Enters, class Visit>
  void each_that(const Enters& enters, const Visit& visit) const
  {
    for (const Bounds& one : endless_)
    {
      visit(one.body);
    }
    if (!nodes_.empty())
    {
      each_below(0, enters, visit);
    }
  }

  /// Bounds [m], world, of all that is finite; empty if nothing is.
  Eigen::AlignedBox<double, 3> finite_box() const
  {
    return nodes_.empty() ? Eigen::AlignedBox<double, 3>() : nodes_[0].box;
  }

private:
  /// Leaves side by side that no node parts any more.
  static constexpr std::size_t most_leaves = 4;

  void grow(std::size_t first, std::size_t end)
  {
    const std::size_t here = nodes_.size();
    Eigen::AlignedBox<double, 3> box, centers;
    for (std::size_t i = first; i < end; ++i)
    {
      box.extend(leaves_[i].box);
      centers.extend(center(leaves_[i]));
    }
    nodes_.push_back({box, first, end, 0});
    if (end - first <= most_leaves)
    {
      return;
    }
    int axis = 0;
    (centers.max() / 2 - centers.min() / 2).maxCoeff(&axis);
    const auto before = [axis](const Bounds& a, const Bounds& b)
    { return std::pair(center(a)[axis], a.body) < std::pair(center(b)[axis], b.body); };
    const std::size_t middle = first + (end - first) / 2;
    const auto at = [this](std::size_t i)
    { return leaves_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(end), before);
    grow(first, middle);
    nodes_[here].right = nodes_.size();
    grow(middle, end);
  }

  static Vector3<double> center(const Bounds& one) { return one.box.min() / 2 + one.box.max() / 2; }

  template <class Enters, class Visit>
  void each_below(std::size_t node, const Enters& enters, const Visit& visit) const
  {
    const Node& here = nodes_[node];
    if (!enters(here.box))
    {
      return;
    }
    if (here.right > 0)
    {
      each_below(node + 1, enters, visit);
      each_below(here.right, enters, visit);
      return;
    }
    for (std::size_t i = here.first; i < here.end; ++i)
    {
      if (enters(leaves_[i].box))
      {
        visit(leaves_[i].body);
      }
    }
  }

  std::vector<Bounds> leaves_, endless_;
  std::vector<Node> nodes_;
};
// [bounds_tree]

} // namespace cookbook
