#pragma once

/// \file
/// \brief A ray against a triangle, without a gap between triangles that share an edge.

#include "01_math/numbers/difference_of_products.hpp"
#include "02_primitives/casts/cast_triangle.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <optional>

namespace cookbook
{

// [ray_triangle_watertight]
/// The view along a ray, for many triangles.
template <class Real>
ShearedView<Wide<Real>> view_along(const Ray<Real>& ray)
{
  return sheared_view<Wide<Real>>({widen(ray.origin), widen(ray.direction), false});
}

/// The t at which a ray meets a triangle, from either side, edges and corners included; nothing
/// for a triangle that it sees edge on.
template <class Real>
std::optional<Wide<Real>>
ray_triangle_watertight(const ShearedView<Wide<Real>>& view, const Triangle<Real>& triangle)
{
  using W = Wide<Real>;
  const LineSpan<W> span = span_of<W>(
      view, seen_along<W>(view, widen(triangle.a)), seen_along<W>(view, widen(triangle.b)),
      seen_along<W>(view, widen(triangle.c)));
  const bool met = span.facing != W(0) && span.first <= span.last && span.first >= W(0);
  return met ? std::optional<W>(span.first) : std::nullopt;
}
// [ray_triangle_watertight]

/// The unit normal of a triangle on the side that a direction comes from; of a flat one, against
/// the direction.
template <class Real>
Vector3<Real> normal_towards(const Triangle<Real>& triangle, const Vector3<Real>& direction)
{
  using V = Vector3<Wide<Real>>;
  const V a = widen(triangle.a), ab = widen(triangle.b) - a, ac = widen(triangle.c) - a;
  const V along = widen(direction);
  const V across = accurate_cross<Wide<Real>>(ab, ac);
  const V normal = normalize<Wide<Real>>(across.isZero(0) ? V(-along) : across).unit;
  const V towards = normal.dot(along) > 0 ? V(-normal) : normal;
  return towards.template cast<Real>();
}

} // namespace cookbook
