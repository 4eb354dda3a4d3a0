#pragma once

/// \file
/// \brief Which bodies of a world may touch: those whose bounds overlap.

#include "06_world/contacts/pair_order.hpp"
#include "06_world/contacts/too_many_contacts.hpp"
#include "06_world/contacts/tree_overlaps.hpp"
#include "06_world/lanes/make_room.hpp"

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
/// Who hardly moves is looked for with wider bounds, its room, and anew once it has left that.
class BroadPhase
{
public:
  /// Calls `call(pair)` with all pairs of bodies whose bounds overlap, in order of number; or
  /// throws TooManyContacts, if there are more than 100 for each body.
  template <class Call>
  void each_pair(std::span<const Bounds> bounds, const Call& call)
  {
    const bool known = tree_.is_of(bounds);
    if (!known || !follow(bounds))
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

  /// A tree of the bounds that pairs were last found of, to be changed. While it is asked for,
  /// nobody is given room.
  BoundsTree& tree(std::span<const Bounds> bounds)
  {
    if (roomy_)
    {
      tree_.refit([&](const Bounds& leaf) { return bounds[place(leaf.body)].box; });
    }
    roomy_ = false;
    asked_ = true;
    return tree_;
  }

private:
  static constexpr double room = 0.05; // of a box's smallest size, on all sides

  std::size_t place(int body) const { return places_[static_cast<std::size_t>(body)]; }

  const Eigen::AlignedBox<double, 3>& room_of(int body) const
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

  /// Whether the bodies of the tree have rooms, and only few have left theirs, now or since pairs
  /// were found; those are given others.
  bool follow(std::span<const Bounds> bounds)
  {
    if (!roomy_)
    {
      return false;
    }
    left_.clear();
    for (std::uint32_t leaf = 0; leaf < bounds.size(); ++leaf)
    {
      const Bounds& known = tree_.all()[leaf];
      if (!known.box.contains(bounds[static_cast<std::size_t>(known.place)].box))
      {
        left_.push_back(leaf);
      }
    }
    moved_ += left_.size();
    const bool few = 8 * left_.size() <= bounds.size() && moved_ <= bounds.size();
    if (few && !left_.empty())
    {
      give_rooms(bounds);
    }
    return few;
  }

  void give_rooms(std::span<const Bounds> bounds)
  {
    roomy_ = false; // until all is done
    for (const std::size_t leaf : left_)
    {
      const std::size_t place = static_cast<std::size_t>(tree_.all()[leaf].place);
      tree_.replace(leaf, roomy(bounds[place].box, room));
    }
    found_.clear();
    for (const std::size_t leaf : left_)
    {
      add_overlaps(tree_, leaf, found_);
    }
    const auto is_known = [&](const auto& pair)
    { return std::binary_search(close_pairs_.begin(), close_pairs_.end(), pair); };
    std::erase_if(found_, is_known);
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    merge_in(close_pairs_, std::span(found_));
    const auto apart = [&](const auto& pair)
    { return !boxes_intersect(room_of(pair.first), room_of(pair.second)); };
    std::erase_if(close_pairs_, apart);
    roomy_ = true;
  }

  /// Finds all pairs anew, and gives room to all known that have hardly moved, or kept to theirs.
  void find(std::span<const Bounds> bounds, bool known)
  {
    const bool gives = known && !asked_;
    const auto room_for = [&](const Bounds& one) // as it was the last time, or with its room
    {
      const auto& now = bounds[static_cast<std::size_t>(one.place)].box;
      const bool stays = gives && (roomy_ ? one.box : roomy(one.box, room / 4)).contains(now);
      return stays ? roomy(now, room) : now;
    };
    if (known)
    {
      tree_.follow(room_for);
    }
    else
    {
      tree_.build(bounds);
    }
    roomy_ = asked_ = false;
    moved_ = 0;
    find_places(bounds);
    close_pairs_.clear();
    each_overlap(
        tree_,
        [&](int a, int b)
        {
          add_in_room(close_pairs_, std::pair(a, b));
          check(std::ssize(close_pairs_), 200);
        });
    order_.sort(close_pairs_, places_.size());
    roomy_ = gives;
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
      places_[static_cast<std::size_t>(one.body)] = static_cast<std::uint32_t>(one.place);
      leaves_[static_cast<std::size_t>(one.body)] = leaf++;
    }
  }

  BoundsTree tree_;
  PairOrder order_;
  std::vector<std::pair<int, int>> close_pairs_, found_; // by their rooms
  std::vector<std::uint32_t> places_, leaves_; // of bodies in the list of bounds, in the tree
  std::vector<std::uint32_t> left_;            // the leaves of those that left their room
  std::size_t moved_ = 0;                      // rooms given since pairs were found
  bool roomy_ = false, asked_ = false; // whether there are rooms; whether the tree was asked for
};
// [overlapping_pairs]

} // namespace cookbook
