#pragma once

/// \file
/// \brief How far apart any two shapes of bodies are, or how deep they overlap, as one signed
/// number.

#include "02_primitives/plain_points/plain_points.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"
#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "05_resolution/tunnelling/swept_box.hpp"
#include "06_world/shapes/convex_gap.hpp"
#include "06_world/shapes/plane_shape.hpp"
#include "06_world/shapes/sphere_shape.hpp"

#include <limits>
#include <variant>

namespace cookbook
{

// [projected_radius]
/// How far [m] a shape reaches from its centre along a unit direction.
inline double projected_radius(const Sphere<double>& sphere, const Vector3<double>&)
{
  return sphere.radius;
}
inline double projected_radius(const Obb<double>& box, const Vector3<double>& direction)
{
  return box_radius(box, direction);
}
inline double projected_radius(const Placed<ConvexShape>& shape, const Vector3<double>& direction)
{
  return direction.dot(support_arm(shape, direction));
}
/// Without end.
inline double projected_radius(const Plane<double>&, const Vector3<double>&)
{
  return std::numeric_limits<double>::infinity();
}
// [projected_radius]

// [gap_of_two]
/// The gap of two shapes where they are: see gap_between().
inline Direction<double> gap_of(const Sphere<double>& a, const Sphere<double>& b)
{
  const Direction<double> centers = normalize<double>(b.center - a.center);
  return {centers.unit, centers.length - a.radius - b.radius};
}
inline Direction<double> gap_of(const Sphere<double>& a, const Obb<double>& b)
{
  const Vector3<double> local = box_coordinates(b, a.center);
  const Direction<double> to_surface = direction_to_box(local, b.axes, b.half_extents);
  return {to_surface.unit, to_surface.length - a.radius};
}
inline Direction<double> gap_of(const Sphere<double>& a, const Plane<double>& b)
{
  return {-b.normal, signed_distance(b, a.center) - a.radius};
}
inline Direction<double> gap_of(const Obb<double>& a, const Obb<double>& b)
{
  return box_gap(a, b);
}
inline Direction<double> gap_of(const Obb<double>& a, const Plane<double>& b)
{
  return {-b.normal, signed_distance(b, a.center) - box_radius(a, b.normal)};
}

/// Of any convex shape: of a sphere by the distance of its centre, of a plane by the lowest point.
inline Direction<double> gap_of(const Sphere<double>& a, const Placed<ConvexShape>& b)
{
  const Direction<double> out = distance(b, a.center);
  return {-out.unit, out.length - a.radius};
}
inline Direction<double> gap_of(const Plane<double>& a, const Placed<ConvexShape>& b)
{
  const Vector3<double> lowest = b.pose.center + support_arm(b, -a.normal);
  return {a.normal, signed_distance(a, lowest)};
}
inline Direction<double> gap_of(const Obb<double>& a, const Placed<ConvexShape>& b)
{
  const BoxShape box{a.half_extents};
  return convex_gap(Placed<BoxShape>{box, {a.center, a.axes}}, b).gap;
}
inline Direction<double> gap_of(const Placed<ConvexShape>& a, const Placed<ConvexShape>& b)
{
  return convex_gap(a, b).gap;
}

/// Two solids without bounds overlap without bounds.
inline Direction<double> gap_of(const Plane<double>& a, const Plane<double>&)
{
  return {a.normal, -std::numeric_limits<double>::infinity()};
}

/// The same, the other way round.
template <class A, class B>
Direction<double> swapped_gap(const A& a, const B& b)
{
  const Direction<double> gap = gap_of(b, a);
  return {-gap.unit, gap.length};
}
inline Direction<double> gap_of(const Obb<double>& a, const Sphere<double>& b)
{
  return swapped_gap(a, b);
}
inline Direction<double> gap_of(const Plane<double>& a, const Sphere<double>& b)
{
  return swapped_gap(a, b);
}
inline Direction<double> gap_of(const Plane<double>& a, const Obb<double>& b)
{
  return swapped_gap(a, b);
}
template <class B>
Direction<double> gap_of(const Placed<ConvexShape>& a, const B& b)
{
  return swapped_gap(a, b);
}
// [gap_of_two]

// [gap_between]
/// The direction from A to B along which two shapes are farthest apart, and how far [m] their
/// projections are apart along it; below zero they overlap by that much along it.
///
/// No two points of A and B are closer than this gap, so that both may move towards each other by
/// it before they touch. Two boxes that face each other with a corner or an edge may be farther
/// apart than that, for their directions are those of the separating axis test.
inline Direction<double>
gap_between(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
  const auto gap = [&](const auto& shape_a, const auto& shape_b)
  { return gap_of(placed(pose_a, shape_a), placed(pose_b, shape_b)); };
  return std::visit(gap, a, b);
}

/// Whether a convex shape overlaps or touches a sphere or a box.
template <class Other>
bool overlaps(const Placed<ConvexShape>& shape, const Other& other)
{
  return gap_of(shape, other).length <= 0;
}
// [gap_between]

} // namespace cookbook
