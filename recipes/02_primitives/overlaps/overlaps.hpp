#pragma once

/// \file
/// \brief Whether any two shapes overlap; touching counts.

#include "02_primitives/boxes_overlap/boxes_overlap.hpp"
#include "02_primitives/closest_points/closest_points.hpp"
#include "02_primitives/triangle_triangle/triangle_triangle.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace cookbook
{

/// Whether two boxes overlap, by the fifteen axes of boxes_overlap(); no answer where the overlap
/// or the gap on an axis is as small as a few roundings.
///
/// Left out are axes shorter than rounding, of edges that are parallel: what rounding hides on them
/// is less than what the axes of faces have to overlap by.
template <class Real>
[[gnu::flatten]] std::optional<bool> overlap_beyond_rounding(const Obb<Real>& a, const Obb<Real>& b)
{
  using Limits = std::numeric_limits<Real>;
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real rounding = 4 * projection_rounding(boxes), sine = 8 * Limits::epsilon();
  if (!(rounding > Limits::min()) || !(rounding < Limits::epsilon() * Limits::max()))
  {
    return std::nullopt;
  }
  Real least = Limits::max();
  for (int i = 0; i < 3 && least >= -rounding; ++i)
  {
    least = std::min({least, face_axis_of_a(boxes, i).overlap, face_axis_of_b(boxes, i).overlap});
  }
  for (int i = 0; i < 3 && least >= -rounding; ++i)
  {
    const Vector3<Real> triple = triple_products(boxes, i);
    for (int j = 0; j < 3; ++j)
    {
      const AxisOverlap<Real> on_axis = edge_axis(boxes, i, j, triple);
      least = on_axis.squared_length > sine * sine ? std::min(least, on_axis.overlap) : least;
    }
  }
  return least < -rounding || least > rounding ? std::optional(least > rounding) : std::nullopt;
}

/// Whether two triangles overlap, by the first eleven of the seventeen axes; no answer where the
/// overlap or the gap on an axis is as small as a few roundings, as always in one plane.
template <class Real>
std::optional<bool> overlap_beyond_rounding(const Triangle<Real>& a, const Triangle<Real>& b)
{
  using W = Wide<Real>;
  using Limits = std::numeric_limits<W>;
  const Vector3<W> origin = widen(a.a);
  const auto seen = [&origin](const Vector3<Real>& p) { return Vector3<W>(widen(p) - origin); };
  const Triangle<W> from_a{seen(a.a), seen(a.b), seen(a.c)},
      from_b{seen(b.a), seen(b.b), seen(b.c)};
  const auto edges_a = edges_of<W>({origin, widen(a.b), widen(a.c)});
  const auto edges_b = edges_of<W>({widen(b.a), widen(b.b), widen(b.c)});
  W size(0);
  for (const Vector3<W>& p : {from_a.b, from_a.c, from_b.a, from_b.b, from_b.c})
  {
    size = std::max(size, p.cwiseAbs().maxCoeff());
  }
  bool in_doubt = false;
  const auto separates = [&](const Vector3<W>& one, const Vector3<W>& other)
  {
    const Vector3<W> axis = one.cross(other);
    const auto of_a = std::minmax({W(0), axis.dot(from_a.b), axis.dot(from_a.c)});
    const auto of_b = std::minmax({axis.dot(from_b.a), axis.dot(from_b.b), axis.dot(from_b.c)});
    const W overlap = std::min(of_a.second - of_b.first, of_b.second - of_a.first);
    const W rounding =
        64 * Limits::epsilon() * size * one.cwiseAbs().maxCoeff() * other.cwiseAbs().maxCoeff();
    const bool in_range = rounding > Limits::min() && rounding < Limits::epsilon() * Limits::max();
    in_doubt = in_doubt || !in_range || !(overlap > rounding);
    return in_range && overlap < -rounding;
  };
  bool separated = separates(edges_a[0], edges_a[1]) || separates(edges_b[0], edges_b[1]);
  for (const Vector3<W>& one : edges_a)
  {
    for (const Vector3<W>& other : edges_b)
    {
      separated = separated || separates(one, other);
    }
  }
  return separated || !in_doubt ? std::optional(!separated) : std::nullopt;
}

// [overlaps]
/// Whether two shapes have a point in common, to rounding.
///
/// Two OBBs and two triangles are asked by their axes first, at about the cost of boxes_overlap()
/// and triangles_meet_by_17_axes(), and by their distance only where these are in doubt.
template <BoundedShape A, BoundedShape B>
bool overlaps(const A& a, const B& b)
{
  using Real = NumberOf<A>;
  if constexpr (requires { overlap_beyond_rounding(a, b); })
  {
    if (const std::optional<bool> by_axes = overlap_beyond_rounding(a, b))
    {
      return *by_axes;
    }
  }
  const PairFrame<Wide<Real>> frame = pair_frame<Real>(a, b);
  return closest_on_hulls(rounded_hull(a, frame), rounded_hull(b, frame)).distance == Wide<Real>(0);
}

/// Whether a half-space and a shape have.
template <class Real, BoundedShape Shape>
bool overlaps(const Plane<Real>& plane, const Shape& shape)
{
  return closest_points(plane, shape).distance == Real(0);
}

/// The same in the other order.
template <BoundedShape Shape, class Real>
bool overlaps(const Shape& shape, const Plane<Real>& plane)
{
  return overlaps(plane, shape);
}

/// Whether two half-spaces have.
template <class Real>
bool overlaps(const Plane<Real>& a, const Plane<Real>& b)
{
  return closest_points(a, b).distance == Real(0);
}
// [overlaps]

} // namespace cookbook
