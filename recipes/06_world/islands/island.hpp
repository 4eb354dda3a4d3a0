#pragma once

/// \file
/// \brief Bodies of a world that hang together by contacts, found anew in each step.

#include "06_world/constraints/constraint_set.hpp"
#include "06_world/contacts/world_contact.hpp"
#include "06_world/islands/find_islands.hpp"
#include "06_world/lanes/groups.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [island]
/// Movable bodies that hang together, their contacts and other constraints; all in order of number.
struct Island
{
  std::span<const int> bodies;        ///< numbers of bodies
  std::span<const int> contacts;      ///< numbers of contacts
  std::span<const int> constraints{}; ///< numbers of constraint pairs
};

/// Whether nothing touches or holds the body of an island.
inline bool is_alone(const Island& island)
{
  return island.contacts.empty() && island.constraints.empty();
}

/// The number in an island of a body of the world; −1 if it is none of its bodies.
inline int number_in(const Island& island, int body)
{
  const auto found = std::lower_bound(island.bodies.begin(), island.bodies.end(), body);
  const bool there = found != island.bodies.end() && *found == body;
  return there ? static_cast<int>(found - island.bodies.begin()) : -1;
}

/// All islands of a world, in order of their first bodies; a body that touches nothing is one too.
class Islands
{
public:
  /// Finds them anew, in the room that there is; `as_one` takes all that is touched or held for
  /// one.
  void find(
      std::span<const RigidBody> bodies, std::span<const WorldContact> contacts,
      std::span<const ConstraintPair> constraints = {}, bool as_one = false)
  {
    const auto moves = [&](int i) { return !is_fixed(bodies[index_of(i)]); };
    const auto join = [&](const auto& pair)
    {
      if (const int body = moves(pair.a) ? pair.a : pair.b; moves(body))
      {
        joined_.emplace_back(joined_.empty() ? body : joined_.back().second, body);
      }
    };
    joined_.clear();
    if (as_one)
    {
      std::for_each(contacts.begin(), contacts.end(), join);
      std::for_each(constraints.begin(), constraints.end(), join);
    }
    numbers_.resize(bodies.size());
    find_islands(numbers_, moves, contacts, constraints, joined_);
    count_ = 0;
    place_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      place_[i] = numbers_[i] == static_cast<int>(i) ? static_cast<int>(count_++) : -1;
    }
    const auto group = [&](int body)
    {
      const int number = numbers_[index_of(body)];
      return number >= 0 ? place_[index_of(number)] : -1;
    };
    bodies_.sort(count_, bodies.size(), [&](std::size_t i) { return group(static_cast<int>(i)); });
    const auto group_of = [&](const auto& pair) { return std::max(group(pair.a), group(pair.b)); };
    contacts_.sort(count_, contacts.size(), [&](std::size_t i) { return group_of(contacts[i]); });
    constraints_.sort(
        count_, constraints.size(), [&](std::size_t i) { return group_of(constraints[i]); });
  }

  std::size_t size() const { return count_; }                  ///< how many there are
  const std::vector<int>& numbers() const { return numbers_; } ///< of every body, as `islands`
  /// One of them.
  Island operator[](std::size_t i) const { return {bodies_[i], contacts_[i], constraints_[i]}; }

private:
  std::size_t count_ = 0;
  std::vector<int> numbers_, place_;
  std::vector<std::pair<int, int>> joined_;
  Groups bodies_, contacts_, constraints_;
};
// [island]

} // namespace cookbook
