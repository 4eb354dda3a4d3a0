#pragma once

/// \file
/// \brief Bodies of a world that hang together by contacts, as solvers are given them.

#include "05_resolution/contacts/world_contact.hpp"
#include "05_resolution/islands/find_islands.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [island]
/// Movable bodies that hang together, and their contacts; both in order of number.
struct Island
{
  std::vector<int> bodies;   ///< numbers of bodies
  std::vector<int> contacts; ///< numbers of contacts
};

/// What a solver may see and change.
struct IslandView
{
  std::span<RigidBody> bodies;      ///< all bodies of the world
  std::span<WorldContact> contacts; ///< all contacts of the world
  Vector3<double> gravity;          ///< [m/s²], world
};

/// The number of the island of every body, −1 for fixed ones.
inline std::vector<int>
island_numbers(std::span<const RigidBody> bodies, std::span<const WorldContact> contacts)
{
  std::vector<bool> movable;
  for (const RigidBody& body : bodies)
  {
    movable.push_back(!is_fixed(body));
  }
  std::vector<std::pair<int, int>> pairs;
  for (const WorldContact& contact : contacts)
  {
    pairs.emplace_back(contact.a, contact.b);
  }
  return islands(movable, pairs);
}

/// The islands themselves, from their numbers, in order of their first bodies; a body that touches
/// nothing is one too.
inline std::vector<Island>
islands_of(const std::vector<int>& first, std::span<const WorldContact> contacts)
{
  std::vector<Island> islands;
  std::vector<std::size_t> place(first.size());
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    if (first[i] == static_cast<int>(i))
    {
      place[i] = islands.size();
      islands.emplace_back();
    }
    if (first[i] >= 0)
    {
      islands[place[static_cast<std::size_t>(first[i])]].bodies.push_back(static_cast<int>(i));
    }
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    const int of_a = first[static_cast<std::size_t>(contacts[i].a)];
    const int of_b = first[static_cast<std::size_t>(contacts[i].b)];
    const int island = std::max(of_a, of_b); // −1 where both are fixed
    if (island >= 0)
    {
      islands[place[static_cast<std::size_t>(island)]].contacts.push_back(static_cast<int>(i));
    }
  }
  return islands;
}
// [island]

} // namespace cookbook
