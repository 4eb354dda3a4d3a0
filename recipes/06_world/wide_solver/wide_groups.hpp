#pragma once

/// \file
/// \brief Contacts put together in groups, colour by colour.

#include "04_obb_manifolds/feature_memory/contact_memory.hpp"
#include "06_world/contact_graph/contact_graph.hpp"
#include "06_world/islands/island_points.hpp"
#include "06_world/lanes/groups.hpp"
#include "06_world/lanes/reserve_space.hpp"
#include "06_world/wide_solver/wide_view.hpp"

#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace cookbook
{

// [wide_groups]
/// The bodies of contacts of a world, by their places among these.
struct PairsOfContacts
{
  IslandView world;
  std::span<const int> contacts; ///< their numbers

  std::size_t size() const { return contacts.size(); }
  std::pair<int, int> operator[](std::size_t i) const
  {
    return pair_of(world.contacts[index_of(contacts[i])]);
  }
};

/// Contacts in groups, no two of which share a body that moves, one in each lane.
class WideGroups
{
public:
  static constexpr int none = -1; ///< the contact of a lane that is left over

  /// Puts these contacts of a world together, as many to a group as it has lanes.
  void find(IslandView world, std::span<const int> contacts, std::size_t lanes)
  {
    graph_.color(
        world.bodies.size(), PairsOfContacts{world, contacts},
        [&](int i) { return !is_fixed(world.bodies[index_of(i)]); });
    const std::size_t most = contacts.size() / lanes + std::size_t(graph_.colors());
    groups_.clear();
    taken_.clear();
    reserve_space(groups_, most);
    reserve_space(taken_, most * lanes);
    points_ = 0;
    for (int color = 0; color < graph_.colors(); ++color)
    {
      take(world, contacts, graph_[color], lanes);
    }
  }

  std::span<const WideGroup> all() const { return groups_; } ///< colour by colour
  std::size_t points() const { return points_; }             ///< of one lane of all groups

  /// For every lane of every group which of the contacts it has, by its place among those given.
  std::span<const int> taken() const { return taken_; }

private:
  /// Of a contact.
  static constexpr std::size_t most_points = std::tuple_size_v<PerPoint<WorldPoint>>;

  /// The contacts of a colour: those with as many points together, so that few lanes idle.
  void
  take(IslandView world, std::span<const int> contacts, std::span<const int> of, std::size_t lanes)
  {
    const auto count = [&](std::size_t i)
    { return world.contacts[index_of(contacts[index_of(of[i])])].points.size(); };
    by_points_.sort(
        most_points + 1, of.size(),
        [&](std::size_t i) { return static_cast<int>(most_points - count(i)); });
    std::size_t lane = 0;
    for (std::size_t fewer = 0; fewer <= most_points; ++fewer)
    {
      for (const int i : by_points_[fewer])
      {
        if (lane++ % lanes == 0)
        {
          groups_.push_back({points_, most_points - fewer});
          points_ += most_points - fewer;
        }
        taken_.push_back(of[index_of(i)]);
      }
    }
    taken_.resize(groups_.size() * lanes, none);
  }

  ContactGraph graph_;
  Groups by_points_;
  std::vector<WideGroup> groups_;
  std::vector<int> taken_;
  std::size_t points_ = 0;
};
// [wide_groups]

} // namespace cookbook
