#pragma once

/// \file
/// \brief Contacts at edges inside a surface, which are none.

#include "06_world/contacts/narrow_phase.hpp"
#include "06_world/seams/flush_face.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <variant>

namespace cookbook
{

// [lay_on_surface]
/// Whether a point [m], world, is in a box, to a tolerance [m].
inline bool is_within(const Obb<double>& box, const Vector3<double>& point, double tolerance)
{
  const Vector3<double> place = box.axes.transpose() * (point - box.center);
  return (place.cwiseAbs() - box.half_extents).maxCoeff() <= tolerance;
}

/// The manifold of two boxes on an axis within a margin [m]; none where they are beside each other,
/// where a manifold would have their nearest point, on the surface of neither.
inline std::optional<Manifold<double>>
manifold_above(const Obb<double>& a, const Obb<double>& b, int axis, double margin)
{
  const std::optional<double> depth = overlap_on(a, b, axis);
  std::optional<Manifold<double>> manifold;
  if (depth && *depth >= -margin)
  {
    manifold = manifold_on(a, b, axis, *depth, margin);
  }
  if (manifold)
  {
    const double tolerance = parallel_tolerance * tolerances_of(a, b).size;
    const ContactPoint<double>& point = manifold->points[0];
    const Vector3<double> half = point.depth / 2 * manifold->normal;
    const bool on_both = is_within(a, point.position + half, tolerance) &&
                         is_within(b, point.position - half, tolerance);
    return on_both ? manifold : std::nullopt;
  }
  return manifold;
}

/// Has a contact lie on a face of its fixed body. A sphere that is not above that face, and a box
/// that has no point above it, are not in contact with it.
inline void lay_on_face(const SeamView& view, RestingContact& of, const Face& face)
{
  WorldContact& contact = *of.contact;
  const RigidBody &a = view.bodies[index_of(contact.a)], &b = view.bodies[index_of(contact.b)];
  const BoxShape* const box_a =
      std::get_if<BoxShape>(&view.scene.bodies[index_of(contact.a)].shape);
  const BoxShape* const box_b =
      std::get_if<BoxShape>(&view.scene.bodies[index_of(contact.b)].shape);
  const std::optional<Manifold<double>> manifold =
      box_a == nullptr || box_b == nullptr ? std::nullopt
                                           : manifold_above(
                                                 placed(a, *box_a), placed(b, *box_b),
                                                 face.axis + (of.fixed_a ? 0 : 3), view.margin);
  if (!manifold)
  {
    note_lost(&view.seams.changes, contact, a, b).all();
    return contact.points.clear();
  }
  update_points(contact, *manifold, a, b, &view.seams.changes);
  of = resting_contact(contact, of.fixed_a);
}

/// Whether the manifold of a contact was built on a face of its fixed body.
inline bool was_built_on(const SeamView& view, const RestingContact& of, const Face& face)
{
  const int axis = face.axis + (of.fixed_a ? 0 : 3);
  return are_parallel(face.normal, of.normal, rounding_angle) &&
         (view.bodies[index_of(of.moving)].is_sphere || !view.is_box(of.fixed) ||
          previous_axis(*of.contact) == axis);
}

/// The surface that a contact of a body is to be decided by: a face that another contact of this
/// body lies on, and which the fixed body continues. All of the body is above that face, so no side
/// nor edge of what continues it can be in its way.
inline std::optional<Face> continued_face(const SeamView& view, std::size_t i)
{
  const Seams& seams = view.seams;
  const RestingContact& of = seams.contacts[i];
  for (std::size_t j = 0; j < seams.contacts.size(); ++j)
  {
    if (j == i || !seams.faces[j])
    {
      continue;
    }
    std::optional<Face> face = flush_face(view, of, *seams.faces[j]);
    if (!face || was_built_on(view, of, *face))
    {
      continue;
    }
    const bool lies_on_it =
        seams.faces[i] && are_parallel(face->normal, seams.faces[i]->normal, flush_tolerance);
    const bool mutual = seams.faces[i] && !lies_on_it &&
                        flush_face(view, seams.contacts[j], *seams.faces[i]).has_value();
    if (!mutual)
    {
      return face;
    }
  }
  return std::nullopt;
}

/// Lays all contacts of a body with fixed ones on the surfaces that these continue.
inline void lay_on_surfaces(const SeamView& view)
{
  Seams& seams = view.seams;
  seams.faces.clear();
  for (const RestingContact& of : seams.contacts)
  {
    seams.faces.push_back(face_of(view, of));
  }
  for (std::size_t i = 0; i < seams.contacts.size(); ++i)
  {
    const std::optional<Face> face = continued_face(view, i);
    if (face)
    {
      lay_on_face(view, seams.contacts[i], *face);
      seams.faces[i] = seams.contacts[i].contact->points.empty() ? std::nullopt : face;
    }
  }
}
// [lay_on_surface]

} // namespace cookbook
