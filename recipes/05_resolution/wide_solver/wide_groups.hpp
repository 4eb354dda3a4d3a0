#pragma once

/// \file
/// \brief Contacts put together in groups, colour by colour.

#include "05_resolution/contact_graph/contact_graph.hpp"
#include "05_resolution/islands/island_points.hpp"
#include "05_resolution/wide_solver/islands_together.hpp"
#include "05_resolution/wide_solver/wide_view.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [wide_groups]
/// Contacts in groups, no two of which share a body that moves, one in each lane.
class WideGroups
{
public:
  static constexpr int none = -1; ///< the contact of a lane that is left over

  /// Puts these contacts of a world together, as many to a group as it has lanes.
  void find(IslandView world, std::span<const int> contacts, std::size_t lanes)
  {
    pairs_.clear();
    for (const int number : contacts)
    {
      pairs_.push_back(pair_of(world.contacts[place_of(number)]));
    }
    graph_.color(
        world.bodies.size(), pairs_, [&](int i) { return !is_fixed(world.bodies[place_of(i)]); });
    const std::size_t most = pairs_.size() / lanes + std::size_t(graph_.colors());
    groups_.clear();
    taken_.clear();
    make_room(groups_, most);
    make_room(taken_, most * lanes);
    points_ = 0;
    for (int color = 0; color < graph_.colors(); ++color)
    {
      count(world, contacts, graph_[color]);
      take(lanes);
    }
  }

  std::span<const WideGroup> all() const { return groups_; } ///< colour by colour
  std::size_t points() const { return points_; }             ///< of one lane of all groups

  /// For every lane of every group which of the contacts it has, by its place among those given.
  std::span<const int> taken() const { return taken_; }

private:
  /// The contacts of a colour: those with as many points together, so that few lanes idle.
  void count(IslandView world, std::span<const int> contacts, std::span<const int> of)
  {
    counted_.clear();
    for (const int taken : of)
    {
      const WorldContact& contact = world.contacts[place_of(contacts[place_of(taken)])];
      counted_.emplace_back(contact.points().size(), taken);
    }
    const auto before = [](const auto& one, const auto& other)
    { return std::pair(other.first, one.second) < std::pair(one.first, other.second); };
    std::sort(counted_.begin(), counted_.end(), before);
  }

  void take(std::size_t lanes)
  {
    for (std::size_t i = 0; i < counted_.size(); i += lanes)
    {
      groups_.push_back({points_, counted_[i].first});
      points_ += groups_.back().points;
      for (std::size_t lane = i; lane < i + lanes; ++lane)
      {
        taken_.push_back(lane < counted_.size() ? counted_[lane].second : none);
      }
    }
  }

  ContactGraph graph_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<std::pair<std::size_t, int>>
      counted_; // how many points a contact has, and which it is
  std::vector<WideGroup> groups_;
  std::vector<int> taken_;
  std::size_t points_ = 0;
};
// [wide_groups]

} // namespace cookbook
