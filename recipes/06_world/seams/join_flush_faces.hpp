#pragma once

/// \file
/// \brief Contacts on flush tiles, decided by the surface that these continue.

#include "06_world/contacts/contact_cache.hpp"
#include "06_world/seams/carry_points.hpp"
#include "06_world/seams/hand_over.hpp"
#include "06_world/seams/lay_on_surface.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace cookbook
{

// [list_resting]
/// Lists the contacts of bodies that touch more than one fixed body, or have lost a point of one.
template <class Inactive>
void list_resting(
    Seams& seams, std::span<const RigidBody> bodies, std::span<const WorldContact> contacts,
    const Inactive& inactive)
{
  seams.resting.clear();
  seams.fixed_bodies.assign(bodies.size(), 0);
  const auto moving_of = [&](const WorldContact& contact)
  {
    const RigidBody &a = bodies[index_of(contact.a)], &b = bodies[index_of(contact.b)];
    const int moving = is_fixed(a) ? contact.b : contact.a;
    const bool on_fixed = (stays(a) && !is_fixed(b)) || (stays(b) && !is_fixed(a));
    return on_fixed && !inactive(moving) ? moving : -1;
  };
  const auto count = [&](int moving)
  {
    std::uint8_t& bodies_touched = seams.fixed_bodies[index_of(moving)];
    bodies_touched = std::min<std::uint8_t>(2, bodies_touched + 1);
  };
  for (const WorldContact& contact : contacts)
  {
    const int moving = moving_of(contact);
    if (moving >= 0)
    {
      count(moving);
    }
  }
  for (const LostPoint& one : seams.changes.lost)
  {
    count(one.moving);
  }
  for (const auto& [a, b] : seams.changes.ghosts)
  {
    count(is_fixed(bodies[index_of(a)]) ? b : a);
  }
  for (std::size_t i = 0; i < contacts.size(); ++i)
  {
    const int moving = moving_of(contacts[i]);
    if (moving >= 0 && seams.fixed_bodies[index_of(moving)] > 1)
    {
      seams.resting.emplace_back(moving, static_cast<int>(i));
    }
  }
  std::sort(seams.resting.begin(), seams.resting.end());
}

/// Calls `call` for every body whose contacts are listed, with these in `seams.contacts`.
template <class Call>
void each_resting(
    Seams& seams, std::span<const RigidBody> bodies, std::span<WorldContact> contacts,
    const Call& call)
{
  for (std::size_t begin = 0, end = 0; begin < seams.resting.size(); begin = end)
  {
    seams.contacts.clear();
    while (end < seams.resting.size() && seams.resting[end].first == seams.resting[begin].first)
    {
      WorldContact& contact = contacts[index_of(seams.resting[end].second)];
      seams.contacts.push_back(resting_contact(contact, is_fixed(bodies[index_of(contact.a)])));
      ++end;
    }
    call();
  }
}

/// Adds contacts of boxes that were taken for ghosts, but lie on a surface that another continues.
template <class Inactive>
void keep_flush_ghosts(
    const SeamView& view, std::vector<WorldContact>& contacts, const Inactive& inactive)
{
  Seams& seams = view.seams;
  seams.begun.clear();
  list_resting(seams, view.bodies, contacts, inactive);
  const auto keep = [&]
  {
    for (const std::pair<int, int>& pair : seams.changes.ghosts)
    {
      const bool fixed_a = is_fixed(view.bodies[index_of(pair.first)]);
      if ((fixed_a ? pair.second : pair.first) != seams.contacts.front().moving)
      {
        continue;
      }
      WorldContact contact = new_contact(view.scene, pair.first, pair.second);
      RestingContact of = resting_contact(contact, fixed_a);
      for (const RestingContact& other : seams.contacts)
      {
        const std::optional<Face> surface = face_of(view, other);
        const std::optional<Face> face = surface ? flush_face(view, of, *surface) : std::nullopt;
        if (face && contact.points.empty())
        {
          lay_on_face(view, of, *face);
        }
      }
      if (!contact.points.empty())
      {
        seams.begun.push_back(std::move(contact));
      }
    }
  };
  each_resting(seams, view.bodies, contacts, keep);
  std::sort(
      seams.begun.begin(), seams.begun.end(),
      [](const WorldContact& one, const WorldContact& other)
      { return pair_of(one) < pair_of(other); });
  merge_sorted(contacts, std::span(seams.begun));
}
// [list_resting]

// [join_flush_faces]
/// Lays the contacts of each body that moves with fixed ones on the surfaces that these continue,
/// not by each tile: what is flush has no edges, points on one surface act as one manifold, and a
/// point that goes from tile to tile keeps its impulses. Until return_points(), after the solver,
/// one contact has the points of all on a surface; the others have none.
template <class Inactive>
void join_flush_faces(
    Seams& seams, const Scene& scene, std::span<const RigidBody> bodies,
    std::vector<WorldContact>& contacts, double margin, const Inactive& inactive)
{
  const SeamView view{seams, scene, bodies, margin};
  if (!seams.changes.ghosts.empty())
  {
    keep_flush_ghosts(view, contacts, inactive);
  }
  list_resting(seams, bodies, contacts, inactive);
  const auto join = [&]
  {
    const bool several = seams.contacts.size() > 1;
    if (several)
    {
      lay_on_surfaces(view);
    }
    hand_over(view);
    if (several)
    {
      join_surfaces(view, contacts);
    }
  };
  each_resting(seams, bodies, contacts, join);
}
// [join_flush_faces]

} // namespace cookbook
