#pragma once

/// \file
/// \brief A tree of bounds, built in n log n, however they lie, that follows them as they move.

#include "06_world/contacts/bounds.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
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
    std::uint32_t first, end;         ///< of its leaves
    std::uint32_t right;              ///< its second child; the first stands behind it; 0: none
  };

  const std::vector<Node>& nodes() const { return nodes_; } ///< the root first
  const std::vector<Bounds>& all() const { return all_; }   ///< first all that is finite
  std::span<const Bounds> leaves() const { return {all_.data(), finite_}; } ///< that
  std::span<const Bounds> unbounded() const
  {
    return std::span(all_).subspan(finite_);
  } ///< all else

  /// Sorts bounds into the tree.
  void build(std::span<const Bounds> bounds)
  {
    all_.assign(bounds.begin(), bounds.end());
    for (std::size_t i = 0; i < all_.size(); ++i)
    {
      all_[i].index = static_cast<int>(i);
    }
    sort();
  }

  /// Whether it was built of the bounds of these bodies, in this order.
  bool is_built_of(std::span<const Bounds> bounds) const
  {
    const auto same = [&](const Bounds& one)
    { return one.body == bounds[static_cast<std::size_t>(one.index)].body; };
    return bounds.size() == all_.size() && std::all_of(all_.begin(), all_.end(), same);
  }

  /// Gives all bodies new bounds, `bounds(one)`, and sorts them anew if they have spread or drawn
  /// together by a fifth since that was done; whether it was.
  template <class BoundsOf>
  bool update(const BoundsOf& bounds)
  {
    for (Bounds& one : std::span(all_).subspan(finite_))
    {
      one.box = bounds(one);
    }
    refit(bounds);
    const double now = total_size();
    if (now <= built_size_ * 6 / 5 && built_size_ <= now * 6 / 5)
    {
      return false;
    }
    sort();
    return true;
  }

  /// Gives all that is finite new bounds; the structure of the tree stays.
  template <class BoundsOf>
  void refit(const BoundsOf& bounds)
  {
    for (Bounds& leaf : std::span(all_).first(finite_))
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

  /// Widens the bounds of one of all by a box [m], and with them all branches above it.
  void enlarge(std::size_t leaf, const Eigen::AlignedBox<double, 3>& box)
  {
    replace(leaf, all_[leaf].box.merged(box));
  }

  /// Gives one of all other bounds, and widens all branches above it by them.
  void replace(std::size_t leaf, const Eigen::AlignedBox<double, 3>& box)
  {
    all_[leaf].box = box;
    if (leaf >= finite_)
    {
      return;
    }
    nodes_[0].box.extend(box);
    for (std::size_t node = 0; nodes_[node].right > 0; nodes_[node].box.extend(box))
    {
      const std::size_t right = nodes_[node].right;
      node = leaf < nodes_[right].first ? node + 1 : right;
    }
  }

  /// Bounds [m], world, of all that is finite; empty if nothing is.
  Eigen::AlignedBox<double, 3> finite_box() const
  {
    return nodes_.empty() ? Eigen::AlignedBox<double, 3>() : nodes_[0].box;
  }

private:
  static constexpr std::size_t max_leaves = 4; // side by side, that no node parts any more
  /// Evaluated along the axes that are asked for.
  static auto center(const Bounds& one) { return one.box.min() / 2 + one.box.max() / 2; }

  void sort()
  {
    const auto is_finite = [](const Bounds& one)
    { return one.box.min().allFinite() && one.box.max().allFinite(); };
    const auto end = std::partition(all_.begin(), all_.end(), is_finite);
    finite_ = static_cast<std::size_t>(end - all_.begin());
    nodes_.clear();
    if (finite_ > 0)
    {
      build_node(0, static_cast<std::uint32_t>(finite_));
    }
    built_size_ = total_size();
  }

  void build_node(std::uint32_t first, std::uint32_t end)
  {
    const std::size_t here = nodes_.size();
    nodes_.push_back({box_around(first, end), first, end, 0});
    if (end - first <= max_leaves)
    {
      return;
    }
    Eigen::AlignedBox<double, 3> centers;
    for (std::size_t i = first; i < end; ++i)
    {
      centers.extend(center(all_[i]));
    }
    Eigen::Index axis = 0;
    (centers.max() / 2 - centers.min() / 2).maxCoeff(&axis);
    const auto before = [axis](const Bounds& a, const Bounds& b)
    { return std::pair(center(a)[axis], a.body) < std::pair(center(b)[axis], b.body); };
    const std::uint32_t middle = first + (end - first) / 2;
    Bounds* const leaf = all_.data();
    std::nth_element(leaf + first, leaf + middle, leaf + end, before);
    build_node(first, middle);
    nodes_[here].right = static_cast<std::uint32_t>(nodes_.size());
    build_node(middle, end);
  }

  /// The sum of the sizes [m] of all boxes.
  double total_size() const
  {
    const auto add = [](double sum, const Node& node) { return sum + node.box.sizes().sum(); };
    return std::accumulate(nodes_.begin(), nodes_.end(), 0.0, add);
  }

  Eigen::AlignedBox<double, 3> box_around(std::size_t first, std::size_t end) const
  {
    Eigen::AlignedBox<double, 3> box;
    for (std::size_t i = first; i < end; ++i)
    {
      box.extend(all_[i].box);
    }
    return box;
  }

  std::vector<Bounds> all_;
  std::size_t finite_ = 0;
  std::vector<Node> nodes_;
  double built_size_ = 0; // [m], its spread when it was built
};
// [bounds_tree]

} // namespace cookbook
