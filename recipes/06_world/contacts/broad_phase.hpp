#pragma once

/// \file
/// \brief Which bodies of a world may touch: those whose bounds overlap.

#include "06_world/contacts/pair_order.hpp"
#include "06_world/contacts/too_many_contacts.hpp"
#include "06_world/contacts/tree_overlaps.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [overlapping_pairs]
/// Finds which bodies may touch, in memory that stays from step to step.
///
/// A body that hardly moves has a fat AABB in the tree, and is found anew once it has left that.
class BroadPhase
{
public:
  /// Calls `call(pair)` with all pairs of bodies whose bounds overlap, in order of number; or
  /// throws TooManyContacts, if there are more than 100 for each body.
  template <class Call>
  void each_pair(std::span<const Bounds> bounds, const Call& call)
  {
    const bool known = tree_.is_built_of(bounds);
    if (!known || !update_tree(bounds))
    {
      find(bounds, known);
    }
    const auto overlap = [&](const std::pair<int, int>& pair)
    { return boxes_intersect(bounds[place(pair.first)].box, bounds[place(pair.second)].box); };
    if (close_pairs_.size() > 100 * bounds.size())
    {
      check(std::count_if(close_pairs_.begin(), close_pairs_.end(), overlap), 100);
    }
    for (const std::pair<int, int>& pair : close_pairs_)
    {
      if (overlap(pair))
      {
        call(pair);
      }
    }
  }

  /// Those pairs, and others that are nearly as near.
  const std::vector<std::pair<int, int>>& close_pairs() const { return close_pairs_; }

  /// The tree of the last bounds, to be changed; while it is asked for, no AABB is fattened.
  BoundsTree& tree(std::span<const Bounds> bounds)
  {
    if (is_fat_)
    {
      tree_.refit([&](const Bounds& leaf) { return bounds[place(leaf.body)].box; });
    }
    is_fat_ = false;
    tree_requested_ = true;
    return tree_;
  }

private:
  static constexpr double fat_margin = 0.05; // of a box's smallest size, on all sides

  std::size_t place(int body) const { return places_[static_cast<std::size_t>(body)]; }

  const Eigen::AlignedBox<double, 3>& fat_bounds_of(int body) const
  {
    return tree_.all()[leaves_[static_cast<std::size_t>(body)]].box;
  }

  void check(std::ptrdiff_t pairs, std::size_t each) const
  {
    const std::size_t bodies = tree_.all().size(), most = each * bodies;
    if (static_cast<std::size_t>(pairs) > most)
    {
      throw TooManyContacts(bodies, most);
    }
  }

  /// Whether the AABBs of the tree are fat, and few bodies have left theirs; those are refitted.
  bool update_tree(std::span<const Bounds> bounds)
  {
    if (!is_fat_)
    {
      return false;
    }
    escaped_.clear();
    for (std::uint32_t leaf = 0; leaf < bounds.size(); ++leaf)
    {
      const Bounds& known = tree_.all()[leaf];
      if (!known.box.contains(bounds[static_cast<std::size_t>(known.index)].box))
      {
        escaped_.push_back(leaf);
      }
    }
    moved_ += escaped_.size();
    const bool few = 8 * escaped_.size() <= bounds.size() && moved_ <= bounds.size();
    if (few && !escaped_.empty())
    {
      fatten_escaped(bounds);
    }
    return few;
  }

  void fatten_escaped(std::span<const Bounds> bounds)
  {
    is_fat_ = false; // until all is done
    for (const std::size_t leaf : escaped_)
    {
      const std::size_t place = static_cast<std::size_t>(tree_.all()[leaf].index);
      tree_.replace(leaf, fattened(bounds[place].box, fat_margin));
    }
    found_.clear();
    for (const std::size_t leaf : escaped_)
    {
      add_overlaps(tree_, leaf, found_);
    }
    const auto is_known = [&](const auto& pair)
    { return std::binary_search(close_pairs_.begin(), close_pairs_.end(), pair); };
    std::erase_if(found_, is_known);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    merge_sorted(close_pairs_, std::span(found_));
    const auto disjoint = [&](const auto& pair)
    { return !boxes_intersect(fat_bounds_of(pair.first), fat_bounds_of(pair.second)); };
    std::erase_if(close_pairs_, disjoint);
    is_fat_ = true;
  }

  /// Finds all pairs anew, and fattens the AABBs of bodies that have hardly moved.
  void find(std::span<const Bounds> bounds, bool known)
  {
    const bool may_fatten = known && !tree_requested_;
    const auto fat_bounds_for = [&](const Bounds& one) // as it was the last time, or fat
    {
      const auto& now = bounds[static_cast<std::size_t>(one.index)].box;
      const bool stays =
          may_fatten && (is_fat_ ? one.box : fattened(one.box, fat_margin / 4)).contains(now);
      return stays ? fattened(now, fat_margin) : now;
    };
    if (known)
    {
      tree_.update(fat_bounds_for);
    }
    else
    {
      tree_.build(bounds);
    }
    is_fat_ = tree_requested_ = false;
    moved_ = 0;
    find_places(bounds);
    close_pairs_.clear();
    each_overlap(
        tree_,
        [&](int a, int b)
        {
          append(close_pairs_, std::pair(a, b));
          check(std::ssize(close_pairs_), 200);
        });
    order_.sort(close_pairs_, places_.size());
    is_fat_ = may_fatten;
  }

  /// Finds where each body is in the list of bounds, and in that of the tree.
  void find_places(std::span<const Bounds> bounds)
  {
    int bodies = 0;
    for (const Bounds& one : bounds)
    {
      bodies = std::max(bodies, one.body + 1);
    }
    places_.resize(static_cast<std::size_t>(bodies));
    leaves_.resize(static_cast<std::size_t>(bodies));
    std::uint32_t leaf = 0;
    for (const Bounds& one : tree_.all())
    {
      places_[static_cast<std::size_t>(one.body)] = static_cast<std::uint32_t>(one.index);
      leaves_[static_cast<std::size_t>(one.body)] = leaf++;
    }
  }

  BoundsTree tree_;
  PairOrder order_;
  std::vector<std::pair<int, int>> close_pairs_, found_; // by their fat AABBs
  std::vector<std::uint32_t> places_, leaves_; // of bodies in the list of bounds, in the tree
  std::vector<std::uint32_t> escaped_;         // leaves whose body left its fat AABB
  std::size_t moved_ = 0;                      // AABBs refitted since pairs were found
  bool is_fat_ = false, tree_requested_ = false;
};
// [overlapping_pairs]

} // namespace cookbook
