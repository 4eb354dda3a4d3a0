#pragma once

/// \file
/// \brief Which bodies of a world may touch: those whose bounds overlap.

#include "05_resolution/contacts/too_many_contacts.hpp"
#include "05_resolution/contacts/tree_overlaps.hpp"
#include "05_resolution/lanes/make_room.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [overlapping_pairs]
/// Finds which bodies may touch, in memory that stays from step to step.
///
/// Who hardly moves is looked for with wider bounds, its room, and not again until it has left
/// that.
class BroadPhase
{
public:
  /// All pairs of bodies whose bounds overlap, in order of number; TooManyContacts if there are
  /// more than 100 for each body.
  const std::vector<std::pair<int, int>>& pairs(std::span<const Bounds> bounds)
  {
    if (!follow(bounds))
    {
      find(bounds);
    }
    pairs_.clear();
    for (const auto& [a, b] : near_)
    {
      if (boxes_intersect(bounds[place(a)].box, bounds[place(b)].box))
      {
        pairs_.emplace_back(a, b);
      }
    }
    check(pairs_.size(), 100);
    return pairs_;
  }

  const std::vector<std::pair<int, int>>& last() const { return pairs_; } ///< the pairs last found

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

  void check(std::size_t pairs, std::size_t most) const
  {
    if (pairs > most * rooms_.size())
    {
      throw TooManyContacts(rooms_.size(), most * rooms_.size());
    }
  }

  /// Whether these are the bodies that have rooms, and only few have left theirs, now or since
  /// pairs were found; those are given others.
  bool follow(std::span<const Bounds> bounds)
  {
    left_.clear();
    bool same = roomy_ && bounds.size() == rooms_.size();
    for (std::size_t i = 0; same && i < bounds.size(); ++i)
    {
      same = bounds[i].body == rooms_[i].body;
      if (!rooms_[i].box.contains(bounds[i].box))
      {
        left_.push_back(i);
      }
    }
    moved_ += left_.size();
    same = same && 8 * left_.size() <= bounds.size() && moved_ <= bounds.size();
    if (same && !left_.empty())
    {
      give_rooms(bounds);
    }
    return same;
  }

  void give_rooms(std::span<const Bounds> bounds)
  {
    for (const std::size_t i : left_)
    {
      rooms_[i].box = roomy(bounds[i].box, room);
      tree_.widen(leaves_[i], rooms_[i].box);
    }
    found_.clear();
    for (const std::size_t i : left_)
    {
      add_overlaps(tree_, leaves_[i], found_);
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    std::vector<std::pair<int, int>>& known = pairs_; // which are found anew after this
    known.swap(near_);
    near_.clear();
    std::set_union(
        known.begin(), known.end(), found_.begin(), found_.end(), std::back_inserter(near_));
    const auto apart = [&](const auto& pair)
    { return !boxes_intersect(rooms_[place(pair.first)].box, rooms_[place(pair.second)].box); };
    near_.erase(std::remove_if(near_.begin(), near_.end(), apart), near_.end());
  }

  /// Finds all pairs anew, and gives room to all that have hardly moved, or kept to their room.
  void find(std::span<const Bounds> bounds)
  {
    const bool gives = !asked_ && bounds.size() == rooms_.size();
    rooms_.resize(bounds.size());
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      const auto& before = rooms_[i].box; // as it was the last time, or its room
      const bool stays =
          gives && (roomy_ ? before : roomy(before, room / 4)).contains(bounds[i].box);
      rooms_[i] = bounds[i];
      rooms_[i].box = stays ? roomy(bounds[i].box, room) : bounds[i].box;
    }
    roomy_ = asked_ = false;
    moved_ = 0;
    if (!tree_.follow(rooms_))
    {
      tree_.build(rooms_);
    }
    leaves_.resize(bounds.size());
    for (std::size_t leaf = 0; leaf < tree_.leaves().size(); ++leaf)
    {
      leaves_[static_cast<std::size_t>(tree_.leaves()[leaf].place)] = leaf;
    }
    int bodies = 0;
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      bodies = std::max(bodies, bounds[i].body + 1);
      places_.resize(static_cast<std::size_t>(bodies));
      places_[static_cast<std::size_t>(bounds[i].body)] = i;
    }
    std::vector<std::pair<int, int>>& found = pairs_; // which are found anew after this
    found.clear();
    each_overlap(
        tree_,
        [&](int a, int b)
        {
          make_room(found, found.size() + 1);
          found.emplace_back(a, b);
          check(found.size(), 200);
        });
    sort_into_near(found, places_.size());
    roomy_ = gives;
  }

  /// Puts pairs that were found in order: first by the first of each, so that few are left.
  void sort_into_near(std::span<const std::pair<int, int>> found, std::size_t bodies)
  {
    next_.assign(bodies + 1, 0);
    for (const auto& pair : found)
    {
      ++next_[static_cast<std::size_t>(pair.first) + 1];
    }
    std::partial_sum(next_.begin(), next_.end(), next_.begin());
    make_room(near_, found.size());
    near_.resize(found.size());
    for (const auto& pair : found)
    {
      near_[next_[static_cast<std::size_t>(pair.first)]++] = pair;
    }
    std::uint32_t first = 0;
    for (std::size_t body = 0; body < bodies; ++body)
    {
      std::sort(near_.begin() + first, near_.begin() + next_[body]);
      first = next_[body];
    }
  }

  BoundsTree tree_;
  std::vector<std::pair<int, int>> pairs_, near_, found_; // near: by their rooms
  std::vector<Bounds> rooms_;                             // by their places in the list of bounds
  std::vector<std::size_t> leaves_, left_; // by the same; the places of those that left
  std::vector<std::size_t> places_;        // of bodies in that list
  std::vector<std::uint32_t> next_;        // where the next pair is put that begins with a body
  std::size_t moved_ = 0;                  // rooms given since pairs were found
  bool roomy_ = false, asked_ = false; // whether there are rooms; whether the tree was asked for
};
// [overlapping_pairs]

} // namespace cookbook
