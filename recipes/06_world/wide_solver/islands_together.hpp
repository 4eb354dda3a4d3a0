#pragma once

/// \file
/// \brief Islands that are solved together, and what is known of the contacts of each.

#include "06_world/islands/island.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace cookbook
{

/// Islands, and their contacts one after the other.
class IslandsTogether
{
public:
  /// Forgets all islands.
  void clear()
  {
    islands_.clear();
    contacts_.clear();
    speeds_.clear();
  }

  /// Adds an island, and how fast [m/s] its overlaps are taken away.
  void add(const Island& island, double correction_speed)
  {
    islands_.push_back(island);
    reserve_space(contacts_, contacts_.size() + island.contacts.size());
    contacts_.insert(contacts_.end(), island.contacts.begin(), island.contacts.end());
    speeds_.push_back(correction_speed);
  }

  /// Calls `call(body)` with the numbers of all bodies, island by island.
  template <class Call>
  void for_each_body(const Call& call) const
  {
    for (const Island& island : islands_)
    {
      for (const int body : island.bodies)
      {
        call(body);
      }
    }
  }

  std::span<const Island> all() const { return islands_; }    ///< as they were added
  std::span<const int> contacts() const { return contacts_; } ///< the numbers of theirs
  /// How fast [m/s] the overlaps of each are taken away.
  std::span<const double> correction_speeds() const { return speeds_; }

private:
  std::vector<Island> islands_;
  std::vector<int> contacts_;
  std::vector<double> speeds_;
};

} // namespace cookbook
