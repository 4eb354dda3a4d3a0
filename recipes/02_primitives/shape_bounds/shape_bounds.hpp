#pragma once

/// \file
/// \brief The support point of a shape, its box along the world's axes, and whether it holds a
/// point.

#include "02_primitives/overlaps/overlaps.hpp"
#include "02_primitives/shape_bounds/bounding_sphere.hpp"
#include "02_primitives/shape_bounds/obb_bounds.hpp"

namespace cookbook
{

/// The support point of a shape: the one farthest along a direction of any length; of the zero
/// vector, any point.
template <BoundedShape Shape>
Vector3<NumberOf<Shape>>
support_point(const Shape& shape, const Vector3<NumberOf<Shape>>& direction)
{
  using Real = NumberOf<Shape>;
  using W = Wide<Real>;
  const PairFrame<W> frame = pair_frame<Real>(shape, shape);
  const auto hull = rounded_hull(shape, frame);
  const Vector3<W> unit = normalize<W>(widen(direction)).unit;
  const std::size_t i = support_index<W>(Corners<W>(hull.corners), unit);
  const Vector3<W> support_point = hull.corners[i] + hull.radius * unit;
  return frame.out(support_point).template cast<Real>();
}

/// The box along the axes around a hull's corners, without its radius.
template <class Real, int Size>
Aabb<Real> box_of_corners(const RoundedHull<Real, Size>& hull)
{
  Aabb<Real> box;
  for (const Vector3<Real>& corner : hull.corners)
  {
    box.extend(corner);
  }
  return box;
}

/// The box along the world's axes around a shape.
template <BoundedShape Shape>
Aabb<NumberOf<Shape>> bounds_of(const Shape& shape)
{
  using Real = NumberOf<Shape>;
  const PairFrame<Wide<Real>> frame = pair_frame<Real>(shape, shape);
  const auto hull = rounded_hull(shape, frame);
  const Aabb<Wide<Real>> box = box_of_corners(hull);
  const Vector3<Wide<Real>> around = Vector3<Wide<Real>>::Constant(hull.radius);
  const Vector3<Wide<Real>> least = box.min() - around, most = box.max() + around;
  return {frame.out(least).template cast<Real>(), frame.out(most).template cast<Real>()};
}

/// Whether a sphere holds a point; its surface belongs to it.
template <class Real>
bool contains(const Sphere<Real>& sphere, const Vector3<Real>& point)
{
  return overlaps(sphere, point);
}

/// Whether a capsule does.
template <class Real>
bool contains(const Capsule<Real>& capsule, const Vector3<Real>& point)
{
  return overlaps(capsule, point);
}

/// Whether the half-space below a plane does.
template <class Real>
bool contains(const Plane<Real>& plane, const Vector3<Real>& point)
{
  return overlaps(plane, point);
}

/// Whether a box along the world's axes does: exactly.
template <class Real>
bool contains(const Aabb<Real>& box, const Vector3<Real>& point)
{
  return box.contains(point);
}

/// Whether a tetrahedron does.
template <class Real>
bool contains(const Tetrahedron<Real>& solid, const Vector3<Real>& point)
{
  return overlaps(solid, point);
}

} // namespace cookbook
