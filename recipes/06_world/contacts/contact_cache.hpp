#pragma once

/// \file
/// \brief All contacts of a world, from frame to frame.

#include "06_world/contacts/broad_phase.hpp"
#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/contacts/pair_order.hpp"
#include "06_world/lanes/reserve_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [world_contacts]
/// The restitution of two bodies of a scene: the larger one.
inline double restitution_of(const Scene& scene, int a, int b)
{
  return std::max(scene.bodies[index_of(a)].restitution, scene.bodies[index_of(b)].restitution);
}

/// The contact of two bodies of a scene that is new: two surfaces meet with the geometric mean of
/// their frictions.
inline WorldContact new_contact(const Scene& scene, int a, int b)
{
  const SceneBody &body_a = scene.bodies[index_of(a)], &body_b = scene.bodies[index_of(b)];
  WorldContact contact;
  contact.a = a;
  contact.b = b;
  contact.friction = std::sqrt(body_a.friction * body_b.friction);
  contact.restitution = restitution_of(scene, a, b);
  return contact;
}

/// Brings contacts up to date with pairs of bodies, which `each_pair(call)` calls `call(pair)`
/// with; both are in order. Pairs that are not as near as `margins_of(a, b)` says have none, and
/// neither have those that ignore each other.
///
/// What is known already keeps its place in the list, as long as no pair before it begins or ends.
/// `inactive(i)` says that a body has not moved since; a contact of two such bodies stays as it is.
/// `begun` is room for those that begin. `changes` says what is no longer there.
template <class EachPair, class MarginsOf, class Inactive>
void update_contacts(
    std::vector<WorldContact>& contacts, std::vector<WorldContact>& begun, ContactChanges& changes,
    const Scene& scene, std::span<const RigidBody> bodies, const EachPair& each_pair,
    const MarginsOf& margins_of, const Inactive& inactive)
{
  begun.clear();
  changes.clear();
  const auto updated = [&](WorldContact& contact)
  {
    const std::size_t a = index_of(contact.a), b = index_of(contact.b);
    const UpdateContact points{
        contact, bodies[a], bodies[b], margins_of(contact.a, contact.b), &changes};
    std::visit(points, scene.bodies[a].shape, scene.bodies[b].shape);
    return !contact.points.empty();
  };
  auto kept = contacts.begin(), known = contacts.begin();
  const auto drop = [&]
  {
    note_lost(&changes, *known, bodies[index_of(known->a)], bodies[index_of(known->b)]).all();
    ++known;
  };
  const auto update = [&](const std::pair<int, int>& pair)
  {
    const bool both_inactive = inactive(pair.first) && inactive(pair.second);
    while (known != contacts.end() && pair_of(*known) < pair)
    {
      drop();
    }
    if (never_touch(scene, bodies, pair))
    {
      return;
    }
    if (known != contacts.end() && pair_of(*known) == pair)
    {
      if (kept != known)
      {
        *kept = std::move(*known);
      }
      ++known;
      kept += both_inactive || updated(*kept) ? 1 : 0;
    }
    else if (!both_inactive)
    {
      append(begun, new_contact(scene, pair.first, pair.second));
      if (!updated(begun.back()))
      {
        begun.pop_back();
      }
    }
  };
  each_pair(update);
  while (known != contacts.end())
  {
    drop();
  }
  contacts.erase(kept, contacts.end());
  merge_sorted(contacts, std::span(begun));
}
// [world_contacts]

} // namespace cookbook
