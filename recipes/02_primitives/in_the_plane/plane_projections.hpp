#pragma once

/// \file
/// \brief Whether two convex polygons overlap, by their projections on axes.

#include "02_primitives/in_the_plane/plane_form.hpp"

#include <optional>
#include <span>

namespace cookbook
{

// [projection]
/// From where to where the projection of a polygon reaches on an axis [m times the axis' length].
template <class Real>
struct Projection
{
  Real least; ///< where it begins
  Real most;  ///< where it ends
};

/// The projection of a polygon on an axis: each corner falls at its dot product with the axis.
///
/// Corners are seen times `factor`, which keeps products in range.
template <class Real>
Projection<Wide<Real>> projection_on(
    std::span<const Vector<Real, 2>> polygon, const Vector<Wide<Real>, 2>& axis,
    Wide<Real> factor = 1)
{
  const Wide<Real> first = axis.dot(widen(polygon[0]) * factor);
  Projection<Wide<Real>> span{first, first};
  for (const Vector<Real, 2>& corner : polygon.subspan(1))
  {
    const Wide<Real> at = axis.dot(widen(corner) * factor);
    span.least = std::min(span.least, at);
    span.most = std::max(span.most, at);
  }
  return span;
}

/// Whether the projections of two polygons on an axis have a gap between them; touching ones have
/// none.
template <class Real>
bool separates(
    const Vector<Wide<Real>, 2>& axis, std::span<const Vector<Real, 2>> a,
    std::span<const Vector<Real, 2>> b, Wide<Real> factor = 1)
{
  const auto of_a = projection_on<Real>(a, axis, factor),
             of_b = projection_on<Real>(b, axis, factor);
  return of_a.most < of_b.least || of_b.most < of_a.least;
}
// [projection]

// [separating_axis]
/// An axis perpendicular to an edge of polygon a on which the projections of a and b have a gap.
template <class Real>
std::optional<Vector<Wide<Real>, 2>> separating_edge(
    std::span<const Vector<Real, 2>> a, std::span<const Vector<Real, 2>> b, Wide<Real> factor)
{
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const Vector<Real, 2>&start = a[i], &end = a[(i + 1) % a.size()];
    const Vector<Wide<Real>, 2> axis =
        quarter_turn<Wide<Real>>(widen(end) * factor - widen(start) * factor);
    if (separates<Real>(axis, a, b, factor))
    {
      return axis;
    }
  }
  return std::nullopt;
}

/// An axis on which the projections of two convex polygons have a gap; nothing where they overlap.
///
/// First x and y, then perpendicular to each edge. Polygons may be flat, or points; their corners
/// are in order, either way round. The axis has any length.
template <class Real>
std::optional<Vector<Wide<Real>, 2>> separating_axis(
    std::span<const Vector<Real, 2>> a, std::span<const Vector<Real, 2>> b, Wide<Real> factor = 1)
{
  const Vector<Wide<Real>, 2> x(1, 0), y(0, 1);
  for (const Vector<Wide<Real>, 2>& axis : {x, y})
  {
    if (separates<Real>(axis, a, b, factor))
    {
      return axis;
    }
  }
  const auto of_a = separating_edge<Real>(a, b, factor);
  return of_a ? of_a : separating_edge<Real>(b, a, factor);
}
// [separating_axis]

// [polygons]
/// Whether two convex polygons have a point in common; touching counts. Neither may be empty.
template <class Real>
bool overlaps(std::span<const Vector<Real, 2>> a, std::span<const Vector<Real, 2>> b)
{
  Real size = 0;
  for (const std::span<const Vector<Real, 2>> polygon : {a, b})
  {
    for (const Vector<Real, 2>& corner : polygon)
    {
      size = std::max(size, largest(corner));
    }
  }
  const int exponent = exponent_to_ordinary<Wide<Real>>(size);
  return !separating_axis<Real>(a, b, std::ldexp(Wide<Real>(1), exponent));
}
// [polygons]

} // namespace cookbook
