#pragma once

/// \file
/// \brief Bodies of a world that hang together by contacts, found anew in each step.

#include "05_resolution/contacts/world_contact.hpp"
#include "05_resolution/islands/find_islands.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [island]
/// Movable bodies that hang together, and their contacts; both in order of number.
struct Island
{
  std::span<const int> bodies;   ///< numbers of bodies
  std::span<const int> contacts; ///< numbers of contacts
};

/// Numbers sorted into groups, one group after the other.
class Groups
{
public:
  /// Sorts the numbers below `count` by `group_of(i)`, from 0 to below `groups`, or −1 for none.
  template <class GroupOf>
  void sort(std::size_t groups, std::size_t count, const GroupOf& group_of)
  {
    starts_.assign(groups + 1, 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const int group = group_of(i);
      if (group >= 0)
      {
        ++starts_[static_cast<std::size_t>(group) + 1];
      }
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    members_.resize(static_cast<std::size_t>(starts_.back()));
    next_ = starts_;
    for (std::size_t i = 0; i < count; ++i)
    {
      const int group = group_of(i);
      if (group >= 0)
      {
        const int place = next_[static_cast<std::size_t>(group)]++;
        members_[static_cast<std::size_t>(place)] = static_cast<int>(i);
      }
    }
  }

  /// The numbers of a group, the least first.
  std::span<const int> operator[](std::size_t group) const
  {
    return std::span(members_).subspan(
        static_cast<std::size_t>(starts_[group]),
        static_cast<std::size_t>(starts_[group + 1] - starts_[group]));
  }

private:
  std::vector<int> starts_, next_, members_;
};

/// All islands of a world, in order of their first bodies; a body that touches nothing is one too.
class Islands
{
public:
  /// Finds them anew, in the room that there is.
  void find(std::span<const RigidBody> bodies, std::span<const WorldContact> contacts)
  {
    numbers_.resize(bodies.size());
    pairs_.clear();
    for (const WorldContact& contact : contacts)
    {
      pairs_.emplace_back(contact.a, contact.b);
    }
    find_islands(
        numbers_, [&](int i) { return !is_fixed(bodies[place_of(i)]); }, pairs_);
    count_ = 0;
    place_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
      place_[i] = numbers_[i] == static_cast<int>(i) ? static_cast<int>(count_++) : -1;
    }
    const auto group = [&](int body)
    {
      const int number = numbers_[place_of(body)];
      return number >= 0 ? place_[place_of(number)] : -1;
    };
    bodies_.sort(count_, bodies.size(), [&](std::size_t i) { return group(static_cast<int>(i)); });
    contacts_.sort(
        count_, contacts.size(),
        [&](std::size_t i) { return std::max(group(contacts[i].a), group(contacts[i].b)); });
  }

  std::size_t size() const { return count_; }                  ///< how many there are
  const std::vector<int>& numbers() const { return numbers_; } ///< of every body, as `islands`
  Island operator[](std::size_t i) const { return {bodies_[i], contacts_[i]}; } ///< one of them

private:
  std::size_t count_ = 0;
  std::vector<int> numbers_, place_;
  std::vector<std::pair<int, int>> pairs_;
  Groups bodies_, contacts_;
};
// [island]

} // namespace cookbook
