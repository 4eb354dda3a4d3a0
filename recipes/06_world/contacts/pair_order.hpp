#pragma once

/// \file
/// \brief Pairs of bodies, and lists of what is between two, put in order where they are.

#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

/// The two bodies of a pair.
inline std::pair<int, int> pair_of(const std::pair<int, int>& pair)
{
  return pair;
}

/// Takes things in among others, away from where they were; both are in the order of their pairs,
/// and so is the result. Room grows by a sixteenth more than they need.
template <class One>
void merge_sorted(std::vector<One>& all, std::span<One> others)
{
  std::size_t known = all.size(), other = others.size();
  reserve_space(all, known + other);
  all.resize(known + other);
  while (other > 0)
  {
    const bool later = known > 0 && pair_of(all[known - 1]) > pair_of(others[other - 1]);
    all[known + other - 1] = std::move(later ? all[known - 1] : others[other - 1]);
    later ? --known : --other;
  }
}

/// Puts pairs in order: first by the first of each, so that few are left to be compared. The room
/// stays from step to step.
class PairOrder
{
public:
  /// Sorts pairs of numbers below `bodies`.
  void sort(std::vector<std::pair<int, int>>& pairs, std::size_t bodies)
  {
    const auto moving_first = [](const auto& pair) { return static_cast<std::size_t>(pair.first); };
    ends_.assign(bodies, 0);
    for (const auto& pair : pairs)
    {
      ++ends_[moving_first(pair)];
    }
    next_.resize(bodies);
    std::exclusive_scan(ends_.begin(), ends_.end(), next_.begin(), std::uint32_t{0});
    std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
    for (std::size_t body = 0; body < bodies; ++body)
    {
      const std::uint32_t begin = body > 0 ? ends_[body - 1] : 0;
      while (next_[body] < ends_[body])
      {
        auto& here = pairs[next_[body]];
        std::swap(here, pairs[next_[moving_first(here)]++]); // with itself, where it belongs here
      }
      std::sort(pairs.data() + begin, pairs.data() + ends_[body]);
    }
  }

private:
  std::vector<std::uint32_t> ends_, next_; // of those that begin with a body
};

} // namespace cookbook
