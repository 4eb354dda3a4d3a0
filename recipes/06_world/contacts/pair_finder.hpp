#pragma once

/// \file
/// \brief How a world finds which bodies may touch: by every pair, or by a tree.

#include "06_world/contacts/broad_phase.hpp"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [pair_finder]
/// Finds which bodies may touch, by their bounds.
class PairFinder
{
public:
  using Pair = std::pair<int, int>; ///< numbers of two bodies, the smaller first

  virtual ~PairFinder() = default;
  /// Calls `call(pair)` with all pairs of bodies whose bounds overlap, in order of number; or
  /// throws TooManyContacts, if there are more than 100 for each body.
  virtual void
  each_pair(std::span<const Bounds> bounds, const std::function<void(const Pair&)>& call) = 0;
  /// Those pairs, and perhaps others that are nearly as near.
  virtual std::span<const Pair> close_pairs() const = 0;
  /// A tree of the same bounds, to be changed.
  virtual BoundsTree& tree(std::span<const Bounds> bounds) = 0;
};
// [pair_finder]

// [every_pair]
/// Compares the bounds of every pair: for a few dozen bodies.
class EveryPair : public PairFinder
{
public:
  void
  each_pair(std::span<const Bounds> bounds, const std::function<void(const Pair&)>& call) override
  {
    pairs_.clear();
    for (std::size_t i = 0; i < bounds.size(); ++i)
    {
      for (std::size_t j = i + 1; j < bounds.size(); ++j)
      {
        if (boxes_intersect(bounds[i].box, bounds[j].box))
        {
          pairs_.push_back(std::minmax(bounds[i].body, bounds[j].body));
        }
      }
    }
    if (const std::size_t most = 100 * bounds.size(); pairs_.size() > most)
    {
      throw TooManyContacts(bounds.size(), most);
    }
    std::sort(pairs_.begin(), pairs_.end());
    std::for_each(pairs_.begin(), pairs_.end(), call);
  }

  std::span<const Pair> close_pairs() const override { return pairs_; }
  BoundsTree& tree(std::span<const Bounds> bounds) override
  {
    tree_.build(bounds);
    return tree_;
  }

private:
  std::vector<Pair> pairs_;
  BoundsTree tree_; // for a sweep
};
// [every_pair]

// [tree_pairs]
/// Asks a tree of bounds: for thousands of bodies.
class TreePairs : public PairFinder
{
public:
  void
  each_pair(std::span<const Bounds> bounds, const std::function<void(const Pair&)>& call) override
  {
    broad_phase_.each_pair(bounds, call);
  }

  std::span<const Pair> close_pairs() const override { return broad_phase_.close_pairs(); }
  BoundsTree& tree(std::span<const Bounds> bounds) override { return broad_phase_.tree(bounds); }

private:
  BroadPhase broad_phase_;
};
// [tree_pairs]

} // namespace cookbook
