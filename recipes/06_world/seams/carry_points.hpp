#pragma once

/// \file
/// \brief Contacts of a body on one surface, which act as one manifold.

#include "04_obb_manifolds/feature_memory/contact_memory.hpp"
#include "05_resolution/friction/friction.hpp"
#include "06_world/seams/flush_face.hpp"
#include "06_world/seams/surface_hull.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace cookbook
{

// [carry_points]
/// Adds the points of all contacts that lie on one surface, and clears these off the list of faces.
inline void take_surface(const SeamView& view, const Face& surface)
{
  Seams& seams = view.seams;
  seams.points.clear();
  seams.together.clear();
  const SurfaceAxes<double> axes = surface_axes(surface.normal);
  for (std::size_t i = 0; i < seams.contacts.size(); ++i)
  {
    const RestingContact& of = seams.contacts[i];
    if (!seams.faces[i] || !are_parallel(seams.faces[i]->normal, surface.normal, flush_tolerance) ||
        !flush_face(view, of, surface))
    {
      continue;
    }
    const RigidBody& moving = view.bodies[index_of(of.moving)];
    for (std::size_t k = 0; k < of.contact->points.size(); ++k)
    {
      const WorldPoint& point = of.contact->points[k];
      const Vector3<double> arm = moving.axes * moving_anchor(of, point);
      seams.points.push_back(
          {axes.along(arm), arm, static_cast<int>(i), static_cast<int>(k), is_known(point),
           view.bodies[index_of(of.fixed)].motion.center, true});
    }
    seams.faces[i].reset();
    seams.together.push_back(static_cast<int>(i));
  }
}

/// Takes the points that a surface does not need off their contacts.
inline void drop_points(const SeamView& view)
{
  Seams& seams = view.seams;
  for (std::size_t k = seams.points.size(); k-- > 0;) // from behind: places before stay
  {
    const SurfacePoint& point = seams.points[k];
    if (!point.kept)
    {
      auto& points = seams.contacts[index_of(point.contact)].contact->points;
      points.erase(points.begin() + point.point);
    }
  }
}

/// Whether contacts of a body are alike for a solver but for their fixed bodies.
inline bool act_as_one(const RestingContact& one, const RestingContact& other)
{
  return one.contact->friction == other.contact->friction &&
         one.contact->restitution == other.contact->restitution &&
         are_parallel(one.normal, other.normal, rounding_angle);
}

/// A point as it is if A is taken for B.
inline WorldPoint flipped(WorldPoint point)
{
  std::swap(point.anchor_a, point.anchor_b);
  point.friction = -point.friction;
  return point;
}

/// A point of one contact in the place of another's fixed body.
inline WorldPoint point_on(
    const SeamView& view, const RestingContact& of, const RestingContact& other,
    const WorldPoint& point)
{
  WorldPoint carried = of.fixed_a == other.fixed_a ? point : flipped(point);
  if (of.fixed != other.fixed)
  {
    const RigidBody &from = view.bodies[index_of(of.fixed)],
                    &to = view.bodies[index_of(other.fixed)];
    Vector3<double>& anchor = other.fixed_a ? carried.anchor_a : carried.anchor_b;
    anchor = to.axes.transpose() * (from.motion.center + from.axes * anchor - to.motion.center);
  }
  return carried;
}

/// Notes the points of all contacts on a surface that are alike, in the order that they would have
/// on one face: by their feature on the body that moves.
inline std::span<CarriedPoint> note_points(const SeamView& view, std::span<const WorldContact> all)
{
  Seams& seams = view.seams;
  const RestingContact& first = seams.contacts[index_of(seams.together.front())];
  const std::size_t before = seams.carried.size();
  for (const int i : seams.together)
  {
    const RestingContact& of = seams.contacts[index_of(i)];
    for (const WorldPoint& point : of.contact->points)
    {
      seams.carried.push_back(
          {point, point_on(view, of, first, point), static_cast<int>(of.contact - all.data()),
           static_cast<int>(first.contact - all.data()), of.fixed_a != first.fixed_a});
    }
  }
  const std::span<CarriedPoint> carried = std::span(seams.carried).subspan(before);
  const auto key = [&](const CarriedPoint& one)
  {
    const Vector3<double>& anchor = moving_anchor(first, one.carried);
    return std::tuple(one.carried.feature % 64, anchor.x(), anchor.y(), anchor.z());
  };
  std::sort(
      carried.begin(), carried.end(),
      [&](const CarriedPoint& one, const CarriedPoint& other) { return key(one) < key(other); });
  return carried;
}

/// Lets the first of the contacts on a surface carry the points of all, until return_points(), if
/// these are alike and no more points than a contact has.
inline void carry_points(const SeamView& view, std::span<const WorldContact> all)
{
  Seams& seams = view.seams;
  const RestingContact& first = seams.contacts[index_of(seams.together.front())];
  std::erase_if(
      seams.together, [&](int i) { return !act_as_one(first, seams.contacts[index_of(i)]); });
  const std::size_t before = seams.carried.size();
  const std::span<const CarriedPoint> carried = note_points(view, all);
  if (carried.size() > std::tuple_size_v<PerPoint<WorldPoint>>)
  {
    return seams.carried.resize(before);
  }
  for (const int i : seams.together)
  {
    seams.contacts[index_of(i)].contact->points.clear();
  }
  for (const CarriedPoint& one : carried)
  {
    first.contact->points.push_back(one.carried);
  }
}

/// Has all contacts of a body on one surface act as one manifold: the corners of their hull.
inline void join_surfaces(const SeamView& view, std::span<const WorldContact> all)
{
  Seams& seams = view.seams;
  for (std::size_t i = 0; i < seams.contacts.size(); ++i)
  {
    if (!seams.faces[i])
    {
      continue;
    }
    const Face surface = *seams.faces[i];
    const double tolerance = height_tolerance(view, seams.contacts[i].moving, surface);
    take_surface(view, surface);
    if (seams.together.size() > 1)
    {
      keep_hull(seams.points, seams.order, seams.hull, tolerance);
      drop_points(view);
      carry_points(view, all);
    }
  }
}

/// Gives points back to the contacts that they were carried for, with what a solver has made of
/// them, and takes contacts without points out.
inline void return_points(Seams& seams, std::vector<WorldContact>& contacts)
{
  for (std::size_t begin = 0, end = 0; begin < seams.carried.size(); begin = end)
  {
    WorldContact& carrier = contacts[index_of(seams.carried[begin].carrier)];
    while (end < seams.carried.size() && seams.carried[end].carrier == seams.carried[begin].carrier)
    {
      CarriedPoint& one = seams.carried[end];
      const WorldPoint at_home = one.point;
      one.point = one.flips ? flipped(carrier.points[end - begin]) : carrier.points[end - begin];
      one.point.anchor_a = at_home.anchor_a;
      one.point.anchor_b = at_home.anchor_b;
      ++end;
    }
    carrier.points.clear();
    for (std::size_t k = begin; k < end; ++k)
    {
      contacts[index_of(seams.carried[k].home)].points.push_back(seams.carried[k].point);
    }
  }
  seams.carried.clear();
  std::erase_if(contacts, [](const WorldContact& contact) { return contact.points.empty(); });
}
// [carry_points]

} // namespace cookbook
