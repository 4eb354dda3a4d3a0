#pragma once

/// \file
/// \brief Where two bodies of a world touch, or will within a margin: manifolds of chapters 3
/// and 4.

#include "04_obb_manifolds/feature_memory/feature_memory.hpp"
#include "05_resolution/contacts/ghost_contact.hpp"
#include "05_resolution/contacts/near_shapes.hpp"
#include "05_resolution/contacts/world_contact.hpp"
#include "common/simd/registers.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace cookbook
{

// [meet]
/// The manifold of two shapes that touch, or will within a margin [m], in this frame.
template <class A, class B>
std::optional<Manifold<double>>
meet(const std::optional<Manifold<double>>&, const A& a, const B& b, double margin)
{
  return within(a, b, margin);
}

/// That of two boxes, on the axis of the frame before unless another is better.
///
/// The axis is that of the boxes once both have grown by half the margin, for only then do they
/// overlap; the points are those of the boxes as they are.
inline std::optional<Manifold<double>> meet(
    const std::optional<Manifold<double>>& before, const Obb<double>& a, const Obb<double>& b,
    double margin)
{
  const Obb<double> grown_a = grown(a, margin / 2), grown_b = grown(b, margin / 2);
  const std::optional<std::pair<int, double>> found =
      box_axis_in<Registers<double>>(grown_a, grown_b);
  if (!found)
  {
    return std::nullopt;
  }
  const auto [axis, overlap] = steady_axis(axis_of(before), grown_a, grown_b, *found);
  const Vector3<double> normal = axis_direction(a, b, axis);
  const double growth = margin / 2 *
                        ((a.axes.transpose() * normal).cwiseAbs().sum() +
                         (b.axes.transpose() * normal).cwiseAbs().sum());
  return box_box_on<Registers<double>>(a, b, axis, overlap - growth, growth + margin);
}

/// Whether two manifolds have points with the same features, in the same order.
inline bool has_same_features(const Manifold<double>& a, const Manifold<double>& b)
{
  const auto same = [](const auto& one, const auto& other) { return one.feature == other.feature; };
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same);
}

/// Gives a contact its manifold of this frame: a point with a feature that was there before keeps
/// what was known of it.
inline void
renew(ContactMemory<double, WorldPoint>& known, const std::optional<Manifold<double>>& manifold)
{
  if (manifold && !known.manifold)
  {
    known.warm = PerPoint<WorldPoint>{};
  }
  else if (manifold && !has_same_features(*known.manifold, *manifold))
  {
    known.warm = carried_by_id(*known.manifold, known.warm, *manifold);
  }
  known.manifold = manifold;
}
// [meet]

// [update_contact]
/// Writes where each point of a manifold is on the surfaces of the two bodies.
inline void anchor(WorldContact& contact, const RigidBody& a, const RigidBody& b)
{
  const Manifold<double>& manifold = *contact.memory.manifold;
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
  {
    const ContactPoint<double>& point = manifold.points[i];
    const Vector3<double> half = manifold.normal * (point.depth / 2);
    contact.memory.warm[i].on_a = a.axes.transpose() * (point.position + half - a.motion.center);
    contact.memory.warm[i].on_b = b.axes.transpose() * (point.position - half - b.motion.center);
  }
}

/// Brings the points of a contact up to date with where its bodies are; none where they are farther
/// apart than a reach [m], or are ghosts within a margin [m].
struct UpdateContact
{
  WorldContact& contact;
  const RigidBody& a;
  const RigidBody& b;
  double margin;
  double reach; // no less than the margin

  template <class ShapeA, class ShapeB>
  void operator()(const ShapeA& shape_a, const ShapeB& shape_b) const
  {
    const auto placed_a = placed(a, shape_a);
    const auto placed_b = placed(b, shape_b);
    std::optional<Manifold<double>> met = meet(contact.memory.manifold, placed_a, placed_b, reach);
    if (met && is_ghost(placed_a, placed_b, met->normal, -met->depth, margin))
    {
      met.reset();
    }
    renew(contact.memory, met);
    if (met)
    {
      anchor(contact, a, b);
    }
  }
  void operator()(const PlaneShape&, const PlaneShape&) const { contact.memory.manifold.reset(); }
};
// [update_contact]

} // namespace cookbook
