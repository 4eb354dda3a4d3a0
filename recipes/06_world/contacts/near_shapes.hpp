#pragma once

/// \file
/// \brief Shapes of bodies where they are, and the manifolds of those that touch or nearly do.

#include "02_primitives/shape_bounds/corner_arm.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "06_world/contacts/start_body.hpp"
#include "06_world/shapes/convex_manifold.hpp"
#include "06_world/shapes/gap_between.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

/// A shape where its body is.
template <class Shape>
auto placed(const RigidBody& body, const Shape& shape)
{
  return placed(pose_of(body), shape);
}

/// The signed gap of two bodies.
inline Direction<double>
gap_between(const Shape& a, const RigidBody& body_a, const Shape& b, const RigidBody& body_b)
{
  return gap_between(a, pose_of(body_a), b, pose_of(body_b));
}

/// A shape with its surface moved out by a margin [m].
inline Obb<double> grown(const Obb<double>& box, double margin)
{
  return {box.center, box.axes, box.half_extents + Vector3<double>::Constant(margin)};
}
inline Sphere<double> grown(const Sphere<double>& sphere, double margin)
{
  return {sphere.center, sphere.radius + margin};
}
inline Plane<double> grown(const Plane<double>& plane, double margin)
{
  return {plane.normal, plane.distance + margin};
}

/// The manifold of two balls.
inline std::optional<Manifold<double>> manifold_of(const Sphere<double>& a, const Sphere<double>& b)
{
  return sphere_sphere(a, b);
}

/// The manifold of a ball and a box.
inline std::optional<Manifold<double>> manifold_of(const Sphere<double>& a, const Obb<double>& b)
{
  return sphere_box(a, b);
}

/// The manifold of a plane and a ball.
inline std::optional<Manifold<double>> manifold_of(const Plane<double>& a, const Sphere<double>& b)
{
  return swapped(sphere_plane(b, a));
}

/// The manifold of a plane and a box: its corners below the plane, each with its number as feature.
inline std::optional<Manifold<double>> manifold_of(const Plane<double>& a, const Obb<double>& b)
{
  if (a.normal.dot(b.center) - a.distance > b.half_extents.sum()) // beyond any corner's reach
  {
    return std::nullopt;
  }
  Manifold<double> manifold{a.normal, 0, {}};
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    const Vector3<double> place = b.center + corner_arm(b, corner);
    const double depth = a.distance - a.normal.dot(place);
    if (depth >= 0)
    {
      manifold.depth = std::max(manifold.depth, depth);
      manifold.points.push_back({place + depth / 2 * a.normal, depth, corner});
    }
  }
  return manifold.points.empty() ? std::nullopt : std::optional(manifold);
}

// [within_margin]
/// The manifold of two shapes that touch, or will within a margin [m]: a depth below zero is a gap.
///
/// A grows by the margin, they meet, and that is taken back: the points are midway between the
/// surfaces as they are.
template <class A, class B>
std::optional<Manifold<double>> manifold_within(const A& a, const B& b, double margin)
{
  std::optional<Manifold<double>> manifold = manifold_of(grown(a, margin), b);
  if (manifold)
  {
    manifold->depth -= margin;
    for (ContactPoint<double>& point : manifold->points)
    {
      point.depth -= margin;
      point.position -= margin / 2 * manifold->normal;
    }
  }
  return manifold;
}

/// The manifold of a sphere and any convex shape, by the distance of its centre.
inline std::optional<Manifold<double>>
manifold_within(const Sphere<double>& a, const Placed<ConvexShape>& b, double margin)
{
  const Direction<double> out = distance(b, a.center);
  const Direction<double> to_surface{-out.unit, out.length};
  const SphereOverlap<double> overlap = sphere_overlap<double>(to_surface, a.radius, 0);
  return overlap.depth >= -margin
             ? std::optional(Manifold<double>{
                   overlap.normal, overlap.depth,
                   ContactPoint<double>{a.center + overlap.position, overlap.depth, 0}})
             : std::nullopt;
}

/// The manifold of a plane and any convex shape.
inline std::optional<Manifold<double>>
manifold_within(const Plane<double>& a, const Placed<ConvexShape>& b, double margin)
{
  return convex_manifold(a, b, margin);
}

/// The manifold of a box and any convex shape.
inline std::optional<Manifold<double>>
manifold_within(const Obb<double>& a, const Placed<ConvexShape>& b, double margin)
{
  const BoxShape box{a.half_extents};
  return convex_manifold(Placed<BoxShape>{box, {a.center, a.axes}}, b, margin);
}

/// The manifold of any two convex shapes.
inline std::optional<Manifold<double>>
manifold_within(const Placed<ConvexShape>& a, const Placed<ConvexShape>& b, double margin)
{
  return convex_manifold(a, b, margin);
}

/// The same, the other way round.
inline std::optional<Manifold<double>>
manifold_within(const Placed<ConvexShape>& a, const Sphere<double>& b, double margin)
{
  return swapped(manifold_within(b, a, margin));
}

/// The same, the other way round.
inline std::optional<Manifold<double>>
manifold_within(const Placed<ConvexShape>& a, const Obb<double>& b, double margin)
{
  return swapped(manifold_within(b, a, margin));
}

/// The same, the other way round.
inline std::optional<Manifold<double>>
manifold_within(const Obb<double>& a, const Sphere<double>& b, double margin)
{
  return swapped(manifold_within(b, a, margin));
}

/// Two planes have no points in common that would be theirs alone.
inline std::optional<Manifold<double>>
manifold_within(const Plane<double>&, const Plane<double>&, double)
{
  return std::nullopt;
}

/// The same, the other way round.
template <class A>
std::optional<Manifold<double>> manifold_within(const A& a, const Plane<double>& b, double margin)
{
  return swapped(manifold_within(b, a, margin));
}
// [within_margin]

} // namespace cookbook
