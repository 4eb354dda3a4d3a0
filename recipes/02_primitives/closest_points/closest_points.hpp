#pragma once

/// \file
/// \brief Where any two shapes are closest.

#include "02_primitives/closest_points/closest_on_hulls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cookbook
{

// [closest_points]
/// A shape that rounded_hull() knows.
template <class Shape>
concept BoundedShape = requires(const Shape& shape)
{
  numbers_of(shape);
};

/// The number type of a shape.
template <BoundedShape Shape>
using NumberOf = typename decltype(numbers_of(std::declval<const Shape&>()))::value_type::Scalar;

/// The answer in the world, in the shapes' own number type.
template <class Real>
ClosestPoints<Real, 3>
in_world(const ClosestPoints<Wide<Real>, 3>& points, const PairFrame<Wide<Real>>& frame)
{
  const Vector3<Real> a = frame.out(points.a).template cast<Real>();
  const Vector3<Real> b = frame.out(points.b).template cast<Real>();
  return {a, b, static_cast<Real>(points.distance / frame.scale)};
}

/// A point of each of two shapes, none closer; where they touch or overlap, one point of both.
///
/// The distance is right to about 1e-13 of the largest coordinate, computed in double for float.
template <BoundedShape A, BoundedShape B>
ClosestPoints<NumberOf<A>, 3> closest_points(const A& a, const B& b)
{
  using Real = NumberOf<A>;
  const PairFrame<Wide<Real>> frame = pair_frame<Real>(a, b);
  const auto points = closest_on_hulls(rounded_hull(a, frame), rounded_hull(b, frame));
  return in_world<Real>(points, frame);
}
// [closest_points]

/// The point of a hull that reaches farthest below a plane, and its height [m] above it; P1.
template <class Real>
struct LowestPoint
{
  Vector3<Real> point; ///< [m]
  Real height;         ///< [m], below zero inside the half-space
};

/// The lowest corner, lower by the radius.
template <class Real, int Size>
LowestPoint<Real>
lowest_point(const RoundedHull<Real, Size>& hull, const Vector3<Real>& normal, Real distance)
{
  const Vector3<Real>* lowest = &hull.corners[0];
  for (const Vector3<Real>& corner : hull.corners)
  {
    lowest = corner.dot(normal) < lowest->dot(normal) ? &corner : lowest;
  }
  return {*lowest - hull.radius * normal, lowest->dot(normal) - distance - hull.radius};
}

// [closest_to_plane]
/// A point of the half-space and a point of a shape, none closer.
///
/// The plane's normal may have any length; the zero normal stands for +y.
template <class Real, BoundedShape Shape>
ClosestPoints<Real, 3> closest_points(const Plane<Real>& plane, const Shape& shape)
{
  using W = Wide<Real>;
  const Vector3<Real> plane_size = Vector3<Real>::Constant(plane.distance);
  const PairFrame<W> frame = pair_frame<Real>(shape, plane_size);
  const Direction<W> normal = normalize<W>(widen(plane.normal));
  const W length = normal.length > W(0) ? normal.length : W(1);
  const W distance = (W(plane.distance) * frame.scale) / length - normal.unit.dot(frame.origin);
  const auto hull = rounded_hull(shape, frame);
  const LowestPoint<W> lowest = lowest_point<W>(hull, normal.unit, distance);
  const W size = std::max(largest_of(hull), frame.origin.cwiseAbs().maxCoeff());
  const W rounding = touching<W> * std::max(size, std::abs(distance));
  const W separation = lowest.height > rounding ? lowest.height : W(0);
  return in_world<Real>({lowest.point - separation * normal.unit, lowest.point, separation}, frame);
}

/// The same in the other order.
template <BoundedShape Shape, class Real>
ClosestPoints<Real, 3> closest_points(const Shape& shape, const Plane<Real>& plane)
{
  const ClosestPoints<Real, 3> swapped = closest_points(plane, shape);
  return {swapped.b, swapped.a, swapped.distance};
}
// [closest_to_plane]

/// A point of each of two half-spaces, none closer. Only opposite ones can be apart.
///
/// Where they overlap: the foot of one of them below the origin, or the point of both planes that
/// is closest to the origin.
template <class Real>
ClosestPoints<Real, 3> closest_points(const Plane<Real>& a, const Plane<Real>& b)
{
  using W = Wide<Real>;
  const W scale = ordinary_scale<W>(std::max(std::abs(W(a.distance)), std::abs(W(b.distance))));
  const PairFrame<W> frame{Vector3<W>::Zero(), scale};
  const Direction<W> n_a = normalize<W>(widen(a.normal)), n_b = normalize<W>(widen(b.normal));
  const W d_a = W(a.distance) * scale / (n_a.length > W(0) ? n_a.length : W(1));
  const W d_b = W(b.distance) * scale / (n_b.length > W(0) ? n_b.length : W(1));
  const Vector3<W> foot_a = d_a * n_a.unit, foot_b = d_b * n_b.unit;
  const W cosine = n_a.unit.dot(n_b.unit);
  const W squared_sine = n_a.unit.cross(n_b.unit).squaredNorm();
  const bool parallel = widen(a.normal).cross(widen(b.normal)).isZero(0);
  if (parallel && cosine < W(0) &&
      -d_a - d_b > touching<W> * std::max(std::abs(d_a), std::abs(d_b)))
  {
    return in_world<Real>({foot_a, -d_b * n_a.unit, -d_a - d_b}, frame);
  }
  Vector3<W> both = foot_b;
  if (parallel ? cosine < W(0) || d_a <= d_b : foot_a.dot(n_b.unit) <= d_b)
  {
    both = foot_a;
  }
  else if (!parallel && foot_b.dot(n_a.unit) > d_a)
  {
    both = ((d_a - cosine * d_b) * n_a.unit + (d_b - cosine * d_a) * n_b.unit) / squared_sine;
  }
  return in_world<Real>({both, both, W(0)}, frame);
}

} // namespace cookbook
