#pragma once

/// \file
/// \brief A ray against a triangle, without a gap between triangles that share an edge.

#include "01_math/numbers/difference_of_products.hpp"
#include "02_primitives/shapes/answers.hpp"
#include "02_primitives/shapes/shapes.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <cmath>
#include <limits>
#include <optional>

namespace cookbook
{

// [ray_view]
/// A ray's own coordinates: it starts at the origin and goes along z, which is its longest part;
/// x and y are sheared, not turned.
template <class Real>
struct RayView
{
  Vector3<Wide<Real>> origin; ///< [m], world
  int x, y, z;                ///< axes of the world
  Wide<Real> per_x, per_y;    ///< [1], how far the ray goes along x and y, for each metre along z
  Wide<Real> length;          ///< of the direction along z
};

/// The coordinates of a ray whose direction is not zero.
template <class Real>
RayView<Real> ray_view(const Ray<Real>& ray)
{
  const Vector3<Wide<Real>> d = widen(ray.direction);
  int z = 0;
  d.cwiseAbs().maxCoeff(&z);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  return {widen(ray.origin), x, y, z, d[x] / d[z], d[y] / d[z], d[z]};
}

/// A corner as the ray sees it; the same for all triangles that share it.
template <class Real>
Vector3<Wide<Real>> seen_by(const RayView<Real>& view, const Vector3<Real>& corner)
{
  const Vector3<Wide<Real>> p = widen(corner) - view.origin;
  const Wide<Real> z = p[view.z];
  return {p[view.x] - view.per_x * z, p[view.y] - view.per_y * z, z};
}
// [ray_view]

// [side_of_edge]
/// Twice the area of the triangle of a, b and the ray, seen along it: its sign is exact, and b, a
/// give the same with the other sign.
template <class W>
W side_of_edge(const Vector3<W>& a, const Vector3<W>& b)
{
  const W one = a.x() * b.y(), other = a.y() * b.x(), side = one - other;
  // Both products and the difference are rounded once: beyond this the sign is certain.
  const W doubt = 4 * std::numeric_limits<W>::epsilon() * (std::abs(one) + std::abs(other));
  return std::abs(side) > doubt ? side : difference_of_products(a.x(), b.y(), a.y(), b.x());
}
// [side_of_edge]

// [ray_triangle_watertight]
/// The t at which a ray meets a triangle, from either side, edges and corners included; nothing
/// for a triangle that it sees edge on.
template <class Real>
std::optional<Wide<Real>>
ray_triangle_watertight(const RayView<Real>& view, const Triangle<Real>& triangle)
{
  using W = Wide<Real>;
  const Vector3<W> a = seen_by(view, triangle.a), b = seen_by(view, triangle.b);
  const Vector3<W> c = seen_by(view, triangle.c);
  const W of_a = side_of_edge<W>(b, c), of_b = side_of_edge<W>(c, a), of_c = side_of_edge<W>(a, b);
  const bool any_left = of_a < W(0) || of_b < W(0) || of_c < W(0);
  const bool any_right = of_a > W(0) || of_b > W(0) || of_c > W(0);
  if (any_left == any_right) // it passes outside, or sees nothing of the inside
  {
    return std::nullopt;
  }
  const W depth = (of_a * a.z() + of_b * b.z() + of_c * c.z()) / (of_a + of_b + of_c);
  const W t = depth / view.length;
  return t >= W(0) ? std::optional<W>(t) : std::nullopt;
}
// [ray_triangle_watertight]

// [normal_towards]
/// The unit normal of a triangle on the side that a direction comes from; of a flat one, against
/// the direction.
template <class Real>
Vector3<Real> normal_towards(const Triangle<Real>& triangle, const Vector3<Real>& direction)
{
  using V = Vector3<Wide<Real>>;
  const V a = widen(triangle.a), ab = widen(triangle.b) - a, ac = widen(triangle.c) - a;
  const V along = widen(direction);
  const V against = normalize<Wide<Real>>(V(-along)).unit;
  const V normal = normalize<Wide<Real>>(accurate_cross<Wide<Real>>(ab, ac), against).unit;
  const V towards = normal.dot(along) > 0 ? V(-normal) : normal;
  return towards.template cast<Real>();
}
// [normal_towards]

} // namespace cookbook
