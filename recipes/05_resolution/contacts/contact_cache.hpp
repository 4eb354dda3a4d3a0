#pragma once

/// \file
/// \brief All contacts of a world, from frame to frame.

#include "05_resolution/contacts/broad_phase.hpp"
#include "05_resolution/contacts/narrow_phase.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [world_contacts]
/// The contact of two bodies of a scene that is new.
///
/// Two surfaces meet with the geometric mean of their frictions and the larger restitution.
inline WorldContact new_contact(const Scene& scene, int a, int b)
{
  const SceneBody& of_a = scene.bodies[static_cast<std::size_t>(a)];
  const SceneBody& of_b = scene.bodies[static_cast<std::size_t>(b)];
  WorldContact contact;
  contact.a = a;
  contact.b = b;
  contact.friction = std::sqrt(of_a.friction * of_b.friction);
  contact.restitution = std::max(of_a.restitution, of_b.restitution);
  return contact;
}

/// Writes the contacts of these pairs of bodies, in their order, out of those of the frame before,
/// which come in the same order; pairs farther apart than a margin [m] have
/// none, and neither have those that ignore each other.
///
/// `still(i)` says that a body has not moved since; a contact of two such bodies stays as it is.
template <class Still>
void next_contacts(
    std::vector<WorldContact>& now, const Scene& scene, std::span<const RigidBody> bodies,
    std::span<const WorldContact> before, std::span<const std::pair<int, int>> pairs, double margin,
    const Still& still)
{
  now.clear();
  auto old = before.begin();
  for (const auto& pair : pairs)
  {
    const std::size_t a = static_cast<std::size_t>(pair.first);
    const std::size_t b = static_cast<std::size_t>(pair.second);
    while (old != before.end() && std::pair(old->a, old->b) < pair)
    {
      ++old;
    }
    const bool known = old != before.end() && std::pair(old->a, old->b) == pair;
    const bool both_still = still(pair.first) && still(pair.second);
    if ((both_still && !known) || ignores(scene, pair))
    {
      continue;
    }
    now.push_back(known ? *old : new_contact(scene, pair.first, pair.second));
    if (!both_still)
    {
      std::visit(
          UpdateContact{now.back(), bodies[a], bodies[b], margin}, scene.bodies[a].shape,
          scene.bodies[b].shape);
    }
    if (!now.back().memory.manifold)
    {
      now.pop_back();
    }
  }
}
// [world_contacts]

} // namespace cookbook
