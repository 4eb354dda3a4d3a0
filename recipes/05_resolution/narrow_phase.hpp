#pragma once

/// \file
/// \brief Where two bodies of a world touch, or will within a margin: manifolds of chapters 3
/// and 4.

#include "03_sphere_manifolds/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_plane.hpp"
#include "03_sphere_manifolds/sphere_sphere.hpp"
#include "05_resolution/ghost_contact.hpp"
#include "05_resolution/world_contact.hpp"

#include <optional>
#include <utility>
#include <variant>

namespace cookbook
{

// [placed]
/// A box where its body is, its faces moved out by a margin [m].
inline Obb<double> placed(const RigidBody& body, const BoxShape& box, double margin)
{
  return {body.position, body.axes, box.half_extents + Vector3<double>::Constant(margin)};
}

/// A ball where its body is, its surface moved out by a margin [m].
inline Sphere<double> placed(const RigidBody& body, const SphereShape& ball, double margin)
{
  return {body.position, ball.radius + margin};
}

/// How much farther [m] a shape reaches along a unit normal once it has grown by a margin [m].
inline double
growth(const RigidBody& body, const BoxShape&, const Vector3<double>& normal, double margin)
{
  return margin * (body.axes.transpose() * normal).cwiseAbs().sum();
}

/// A ball grows alike in all directions.
inline double growth(const RigidBody&, const SphereShape&, const Vector3<double>&, double margin)
{
  return margin;
}
// [placed]

// [meet]
/// The memory of a contact whose shapes have no choice of axis.
inline ContactMemory<double, WorldPoint> remembered(
    const ContactMemory<double, WorldPoint>& before, std::optional<Manifold<double>> manifold)
{
  ContactMemory<double, WorldPoint> now{std::move(manifold), {}};
  if (now.manifold && before.manifold)
  {
    now.warm = carried_by_id(*before.manifold, before.warm, *now.manifold);
  }
  return now;
}

/// Two grown boxes that met before, or not.
inline ContactMemory<double, WorldPoint>
meet(const ContactMemory<double, WorldPoint>& before, const Obb<double>& a, const Obb<double>& b)
{
  return next_frame(before, a, b);
}

/// Two balls.
inline ContactMemory<double, WorldPoint> meet(
    const ContactMemory<double, WorldPoint>& before, const Sphere<double>& a,
    const Sphere<double>& b)
{
  return remembered(before, sphere_sphere(a, b));
}

/// A ball and a box.
inline ContactMemory<double, WorldPoint>
meet(const ContactMemory<double, WorldPoint>& before, const Sphere<double>& a, const Obb<double>& b)
{
  return remembered(before, sphere_box(a, b));
}

/// A box and a ball.
inline ContactMemory<double, WorldPoint>
meet(const ContactMemory<double, WorldPoint>& before, const Obb<double>& a, const Sphere<double>& b)
{
  return remembered(before, swapped(sphere_box(b, a)));
}

/// A plane and a ball.
inline std::optional<Manifold<double>>
plane_manifold(const Plane<double>& plane, const Sphere<double>& ball)
{
  return swapped(sphere_plane(ball, plane));
}

/// A plane and a box: its corners below the plane, each with its number as feature.
inline std::optional<Manifold<double>>
plane_manifold(const Plane<double>& plane, const Obb<double>& box)
{
  Manifold<double> manifold{plane.normal, 0, {}};
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vector3<double> sides(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Vector3<double> place = box.center + box.axes * box.half_extents.cwiseProduct(sides);
    const double depth = plane.distance - plane.normal.dot(place);
    if (depth >= 0)
    {
      manifold.depth = std::max(manifold.depth, depth);
      manifold.points.push_back({place + depth / 2 * plane.normal, depth, corner});
    }
  }
  return manifold.points.empty() ? std::nullopt : std::optional(manifold);
}
// [meet]

// [update_contact]
/// Writes where each point of a manifold of grown shapes is on the two bodies as they are.
inline void anchor(WorldContact& contact, const RigidBody& a, const RigidBody& b, double grown)
{
  const Manifold<double>& manifold = *contact.memory.manifold;
  for (std::size_t i = 0; i < manifold.points.size(); ++i)
  {
    const ContactPoint<double>& point = manifold.points[i];
    const Vector3<double> half = manifold.normal * ((point.depth - grown) / 2);
    contact.memory.warm[i].on_a = a.axes.transpose() * (point.position + half - a.position);
    contact.memory.warm[i].on_b = b.axes.transpose() * (point.position - half - b.position);
  }
}

/// Brings the points of a contact up to date with where its bodies are; none where they are farther
/// apart than a margin [m].
struct UpdateContact
{
  WorldContact& contact;
  const RigidBody& a;
  const RigidBody& b;
  double margin;

  template <class ShapeA, class ShapeB>
  void operator()(const ShapeA& shape_a, const ShapeB& shape_b) const
  {
    const double half = margin / 2;
    contact.memory = meet(contact.memory, placed(a, shape_a, half), placed(b, shape_b, half));
    if (!contact.memory.manifold)
    {
      return;
    }
    const Vector3<double>& normal = contact.normal();
    const double grown = growth(a, shape_a, normal, half) + growth(b, shape_b, normal, half);
    anchor(contact, a, b, grown);
    const double gap = grown - contact.memory.manifold->depth;
    if (is_ghost(placed(a, shape_a, 0), placed(b, shape_b, 0), normal, gap, margin))
    {
      contact.memory = {};
    }
  }
  template <class Shape>
  void operator()(const PlaneShape& plane, const Shape& shape) const
  {
    rest_on(plane_manifold(raised(plane), placed(b, shape, 0)));
  }
  template <class Shape>
  void operator()(const Shape& shape, const PlaneShape& plane) const
  {
    rest_on(swapped(plane_manifold(raised(plane), placed(a, shape, 0))));
  }
  void operator()(const PlaneShape&, const PlaneShape&) const { contact.memory = {}; }

  /// A plane that has grown by the whole margin.
  Plane<double> raised(const PlaneShape& plane) const
  {
    return {plane.normal, plane.offset + margin};
  }
  /// Takes a manifold with such a plane, if there is one.
  void rest_on(std::optional<Manifold<double>> manifold) const
  {
    contact.memory = remembered(contact.memory, std::move(manifold));
    if (contact.memory.manifold)
    {
      anchor(contact, a, b, margin);
    }
  }
};
// [update_contact]

} // namespace cookbook
