#pragma once

/// \file
/// \brief A tree of bounds, built in n log n, however they lie, that follows them as they move.

#include "05_resolution/contacts/bounds.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

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
    for (Bounds one : bounds)
    {
      one.place = static_cast<int>(leaves_.size() + endless_.size());
      const bool finite = one.box.min().allFinite() && one.box.max().allFinite();
      (finite ? leaves_ : endless_).push_back(one);
    }
    if (!leaves_.empty())
    {
      grow(0, leaves_.size());
    }
    built_ = spread();
  }

  /// Takes new bounds of the bodies that it was built of. False if they are others, or have spread
  /// or drawn together by a fifth: then it has to be built.
  bool follow(std::span<const Bounds> bounds)
  {
    bool same = bounds.size() == leaves_.size() + endless_.size();
    const auto box_of = [&](const Bounds& one)
    {
      const Bounds& now = same ? bounds[static_cast<std::size_t>(one.place)] : one;
      same = same && now.body == one.body;
      return now.box;
    };
    for (Bounds& one : endless_)
    {
      one.box = box_of(one);
    }
    refit(box_of);
    const double now = spread();
    return same && now <= built_ * 6 / 5 && built_ <= now * 6 / 5;
  }

  /// Gives all that is finite new bounds, `bounds(leaf)`; who lies beside whom in the tree stays.
  template <class BoundsOf>
  void refit(const BoundsOf& bounds)
  {
    for (Bounds& leaf : leaves_)
    {
      leaf.box = bounds(leaf);
    }
    for (std::size_t i = nodes_.size(); i-- > 0;)
    {
      Node& node = nodes_[i];
      node.box = node.right > 0 ? nodes_[i + 1].box.merged(nodes_[node.right].box)
                                : box_around(node.first, node.end);
    }
  }

  /// Widens the bounds of a leaf by a box [m], and with them all branches above it.
  void widen(std::size_t leaf, const Eigen::AlignedBox<double, 3>& box)
  {
    leaves_[leaf].box.extend(box);
    nodes_[0].box.extend(box);
    for (std::size_t node = 0; nodes_[node].right > 0; nodes_[node].box.extend(box))
    {
      const std::size_t right = nodes_[node].right;
      node = leaf < nodes_[right].first ? node + 1 : right;
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
  static constexpr std::size_t most_leaves = 4; // side by side, that no node parts any more
  /// Evaluated along the axes that are asked for.
  static auto center(const Bounds& one) { return one.box.min() / 2 + one.box.max() / 2; }

  void grow(std::size_t first, std::size_t end)
  {
    const std::size_t here = nodes_.size();
    nodes_.push_back({box_around(first, end), first, end, 0});
    if (end - first <= most_leaves)
    {
      return;
    }
    Eigen::AlignedBox<double, 3> centers;
    for (std::size_t i = first; i < end; ++i)
    {
      centers.extend(center(leaves_[i]));
    }
    Eigen::Index axis = 0;
    (centers.max() / 2 - centers.min() / 2).maxCoeff(&axis);
    const auto before = [axis](const Bounds& a, const Bounds& b)
    { return std::pair(center(a)[axis], a.body) < std::pair(center(b)[axis], b.body); };
    const std::size_t middle = first + (end - first) / 2;
    Bounds* const leaf = leaves_.data();
    std::nth_element(leaf + first, leaf + middle, leaf + end, before);
    grow(first, middle);
    nodes_[here].right = nodes_.size();
    grow(middle, end);
  }

  /// The sum of the sizes [m] of all boxes.
  double spread() const
  {
    const auto add = [](double sum, const Node& node) { return sum + node.box.sizes().sum(); };
    return std::accumulate(nodes_.begin(), nodes_.end(), 0.0, add);
  }

  Eigen::AlignedBox<double, 3> box_around(std::size_t first, std::size_t end) const
  {
    Eigen::AlignedBox<double, 3> box;
    for (std::size_t i = first; i < end; ++i)
    {
      box.extend(leaves_[i].box);
    }
    return box;
  }

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
      return each_below(here.right, enters, visit);
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
  double built_ = 0; // [m], its spread when it was built
};
// [bounds_tree]

} // namespace cookbook
