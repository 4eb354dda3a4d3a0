#pragma once

/// \file
/// \brief Where two bodies of a world touch, or will within a margin: manifolds of chapters 3
/// and 4.

#include "04_obb_manifolds/box_box/box_box_in_registers.hpp"
#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "04_obb_manifolds/feature_memory/leaning_edges.hpp"
#include "06_world/contacts/ghost_contact.hpp"
#include "06_world/contacts/near_shapes.hpp"
#include "06_world/contacts/world_contact.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace cookbook
{

// [steady_manifold]
/// The manifold of two shapes that touch, or will within a margin [m], in this frame.
template <class A, class B>
std::optional<Manifold<double>> steady_manifold(int, const A& a, const B& b, double margin)
{
  return manifold_within(a, b, margin);
}

/// Edges of two boxes that lie along each other to within this fraction of all their half extents
/// together do not cross: where they did would be chance, and another place in every step.
inline constexpr double parallel_tolerance = 1e-10;

/// The manifold of two boxes that lean on each other with parallel edges at the face of an axis;
/// its features are none of a face's own.
inline std::optional<Manifold<double>>
leaning_on(int axis, const Obb<double>& a, const Obb<double>& b, double margin)
{
  constexpr std::uint32_t first_feature = 32, features = 64; // a face's own end at 8 · 2 + 7
  const double width = axis_margin(a, b, 0.0);
  const bool of_a = axis_kind(axis) == AxisKind::face_of_a;
  std::optional<Manifold<double>> leaning =
      of_a ? leaning_manifold(a, b, axis, width, margin)
           : swapped(leaning_manifold(b, a, axis - 3, width, margin));
  if (leaning)
  {
    leaning->points[0].feature = features * static_cast<std::uint32_t>(axis) + first_feature;
    leaning->points[1].feature = leaning->points[0].feature + 1;
  }
  return leaning;
}

/// How much more [m] two boxes overlap along an axis, 0 … 14, once both have grown by half a margin
/// [m].
inline double growth_on(const Obb<double>& a, const Obb<double>& b, int axis, double margin)
{
  const Vector3<double> normal = axis_direction(a, b, axis);
  return margin / 2 *
         ((a.axes.transpose() * normal).cwiseAbs().sum() +
          (b.axes.transpose() * normal).cwiseAbs().sum());
}

/// The manifold of two boxes on an axis, 0 … 14, along which they overlap by a depth [m], below
/// zero where they are apart; its points are those within a margin [m].
inline std::optional<Manifold<double>>
manifold_on(const Obb<double>& a, const Obb<double>& b, int axis, double depth, double margin)
{
  const double separation = growth_on(a, b, axis, margin) + margin;
  const double tolerance = parallel_tolerance * tolerances_of(a, b).size;
  return box_box_on<RowInRegisters<double>>(a, b, axis, depth, separation, tolerance);
}

/// That of two boxes, on the axis of the frame before, −1 if there was none, unless another is
/// better, or a face nearly as good as a pair of edges.
///
/// The axis is that of the boxes once both have grown by half the margin, for only then do they
/// overlap; the points are those of the boxes as they are.
inline std::optional<Manifold<double>>
steady_manifold(int before, const Obb<double>& a, const Obb<double>& b, double margin)
{
  const Obb<double> grown_a = grown(a, margin / 2), grown_b = grown(b, margin / 2);
  const std::optional<std::pair<int, double>> found =
      box_axis_in<RowInRegisters<double>>(grown_a, grown_b);
  if (!found)
  {
    return std::nullopt;
  }
  const auto [axis, overlap] = steady_axis(before, grown_a, grown_b, *found);
  if (axis_kind(axis) != AxisKind::edges)
  {
    if (std::optional<Manifold<double>> leaning = leaning_on(axis, a, b, margin))
    {
      return leaning;
    }
  }
  return manifold_on(a, b, axis, overlap - growth_on(a, b, axis, margin), margin);
}

/// The axis on which the manifold of a contact was built in the frame before; −1 if it had none.
inline int previous_axis(const WorldContact& contact)
{
  return contact.points.empty() ? -1 : axis_of_feature(contact.points.front().feature);
}

/// Whether a contact has points with the features of a manifold, in the same order.
inline bool has_same_features(const WorldContact& contact, const Manifold<double>& manifold)
{
  const auto same = [](const auto& one, const auto& other) { return one.feature == other.feature; };
  return std::equal(
      contact.points.begin(), contact.points.end(), manifold.points.begin(), manifold.points.end(),
      same);
}
// [steady_manifold]

// [update_contact]
/// Which bodies are in contact.
struct ContactMargins
{
  double contact; ///< [m], how far apart they may be
  double ghost;   ///< [m], by how much what only passes by may overlap, is_ghost()
};

/// Writes where each point of a contact is on the surfaces of its two bodies, as its manifold says.
inline void set_anchors(
    WorldContact& contact, const Manifold<double>& manifold, const RigidBody& a, const RigidBody& b,
    const NoteLost& note)
{
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
  {
    const ContactPoint<double>& point = manifold.points[i];
    WorldPoint& known = contact.points[i];
    const Vector3<double> half = manifold.normal * (point.depth / 2);
    const Vector3<double> anchor_a = a.axes.transpose() * (point.position + half - a.motion.center);
    const Vector3<double> anchor_b = b.axes.transpose() * (point.position - half - b.motion.center);
    const Vector3<double>& now = note.moving(anchor_a, anchor_b);
    const Vector3<double> moved = now - note.moving(known.anchor_a, known.anchor_b);
    if (moved.squaredNorm() > stays_in_place * stays_in_place * now.squaredNorm())
    {
      note(known);
    }
    known.anchor_a = anchor_a;
    known.anchor_b = anchor_b;
  }
}

/// Gives a contact the normal and points of a manifold of its two bodies: a point with a feature
/// that was there before keeps what was known of it. Points that are no longer where they were on a
/// body are noted as lost.
inline void update_points(
    WorldContact& contact, const Manifold<double>& manifold, const RigidBody& a, const RigidBody& b,
    ContactChanges* changes = nullptr)
{
  const NoteLost note = note_lost(changes, contact, a, b);
  if (!has_same_features(contact, manifold))
  {
    PerPoint<WorldPoint> points =
        carried_points<WorldPoint>(contact.points, contact.points, manifold.points);
    for (std::size_t i = 0; i < manifold.points.size(); ++i)
    {
      points[i].feature = manifold.points[i].feature;
    }
    for (const WorldPoint& point : contact.points)
    {
      const auto same = [&](const auto& one) { return one.feature == point.feature; };
      if (std::none_of(manifold.points.begin(), manifold.points.end(), same))
      {
        note(point);
      }
    }
    if (contact.points.capacity() > manifold.points.size())
    {
      contact.points = std::vector<WorldPoint>(); // a list is as long as what is in it
    }
    contact.points.assign(points.begin(), points.begin() + manifold.points.size());
  }
  set_anchors(contact, manifold, a, b, note);
  contact.normal = manifold.normal;
}

/// Brings the points of a contact up to date with where its bodies are; none where they are too far
/// apart, or are ghosts.
struct UpdateContact
{
  WorldContact& contact;
  const RigidBody& a;
  const RigidBody& b;
  ContactMargins margins;
  ContactChanges* changes = nullptr; ///< where it is noted what is no contact

  template <class ShapeA, class ShapeB>
  void operator()(const ShapeA& shape_a, const ShapeB& shape_b) const
  {
    const auto placed_a = placed(a, shape_a);
    const auto placed_b = placed(b, shape_b);
    const std::optional<Manifold<double>> found =
        steady_manifold(previous_axis(contact), placed_a, placed_b, margins.contact);
    const bool ghost =
        found && is_ghost(placed_a, placed_b, found->normal, -found->depth, margins.ghost);
    if (!found || ghost)
    {
      note_lost(changes, contact, a, b).all();
      if (ghost && changes != nullptr && !a.is_sphere && !b.is_sphere && stays(a) != stays(b))
      {
        changes->ghosts.push_back(pair_of(contact));
      }
      return contact.points.clear();
    }
    update_points(contact, *found, a, b, changes);
  }
};
// [update_contact]

} // namespace cookbook
