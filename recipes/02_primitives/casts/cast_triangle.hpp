#pragma once

/// \file
/// \brief Where a path first meets a triangle, without a gap at its edges.

#include "01_math/numbers/difference_of_products.hpp"
#include "02_primitives/casts/cast_path.hpp"

#include <limits>

namespace cookbook
{

// [sheared_view]
/// The view along a path: its line is the third axis, and t the third coordinate.
template <class Real>
struct ShearedView
{
  Vector3<Real> origin; ///< [m]
  int x, y, z;          ///< axes of the world; the direction's largest component is along z
  Real per_x, per_y;    ///< [1], how far the path goes along x and y, for each metre along z
  Real along_z;         ///< [1], the direction's component along z
};

/// The view along a path; along z if its direction is zero.
template <class Real>
ShearedView<Real> sheared_view(const CastPath<Real>& path)
{
  const bool moves = !path.direction.isZero(0);
  const Vector3<Real> d = moves ? path.direction : Vector3<Real>::UnitZ();
  int z = 0;
  d.cwiseAbs().maxCoeff(&z);
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  return {path.origin, x, y, z, d[x] / d[z], d[y] / d[z], d[z]};
}

/// A point in that view; the same for every triangle that has it as a corner.
template <class Real>
Vector3<Real> seen_along(const ShearedView<Real>& view, const Vector3<Real>& point)
{
  const Vector3<Real> p = point - view.origin;
  const Real depth = p[view.z];
  return {p[view.x] - depth * view.per_x, p[view.y] - depth * view.per_y, depth / view.along_z};
}
// [sheared_view]

// [line_span]
/// The part of a line that lies in a shape.
template <class Real>
struct LineSpan
{
  Real first, last; ///< t; no part if first > last
  Real facing;      ///< > 0 where the corners turn anticlockwise in the view, 0 where edge on

  /// The same, but 0 also where the corners turn by rounding only.
  Real certain_facing() const { return first < last ? Real(0) : facing; }
};
// [line_span]

// [edge_side]
/// The part of the line that lies in a triangle which is seen edge on: its plane holds the line.
///
/// A corner closer to the line than `rounding` is on it.
template <class Real>
LineSpan<Real> span_edge_on(
    const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& c, const Real& facing,
    const Real& rounding)
{
  const Real infinite = std::numeric_limits<Real>::infinity();
  const Vector3<Real> all[] = {a, b, c};
  const Vector3<Real> widest = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs());
  const int side = widest.x() >= widest.y() ? 0 : 1;
  LineSpan<Real> span{infinite, -infinite, facing};
  const auto include = [&](const Real& t)
  {
    span.first = t < span.first ? t : span.first;
    span.last = t > span.last ? t : span.last;
  };
  for (int i = 0; i < 3; ++i)
  {
    const Vector3<Real>&p = all[i], &q = all[(i + 1) % 3];
    if (std::abs(p[side]) <= rounding)
    {
      include(p.z());
    }
    else if ((p[side] < Real(0)) != (q[side] < Real(0)) && q[side] != Real(0))
    {
      include(p.z() + (q.z() - p.z()) * (p[side] / (p[side] - q[side])));
    }
  }
  return span;
}

/// On which side of the edge from p to q the line passes: the sign of p x q, which is right.
///
/// Where rounding might decide, the products are taken exactly.
template <class Real>
Real edge_side(const Vector3<Real>& p, const Vector3<Real>& q)
{
  const Real first = p.x() * q.y(), second = p.y() * q.x(), side = first - second;
  const Real doubt = std::numeric_limits<Real>::min() + Real(2) *
                                                            std::numeric_limits<Real>::epsilon() *
                                                            (std::abs(first) + std::abs(second));
  return std::abs(side) > doubt ? side : difference_of_products(p.x(), q.y(), p.y(), q.x());
}
// [edge_side]

// [span_of]
/// The part of the line that lies in a triangle with these corners in its view.
///
/// Each edge gives a number whose sign tells on which side of it the line passes. The sign is right
/// for the corners as they are seen, and triangles that share an edge agree about it: P12. In a
/// thin triangle the numbers are exact too; one without an area but for rounding is seen edge on.
template <class Real>
LineSpan<Real> span_of(
    const ShearedView<Real>& view, const Vector3<Real>& a, const Vector3<Real>& b,
    const Vector3<Real>& c)
{
  Real bc = edge_side<Real>(b, c), ca = edge_side<Real>(c, a), ab = edge_side<Real>(a, b);
  const Real zero(0);
  if ((bc < zero || ca < zero || ab < zero) && (bc > zero || ca > zero || ab > zero))
  {
    return {Real(1), zero, zero};
  }
  Real sum = ab + bc + ca;
  const Vector3<Real> widest = a.cwiseAbs().cwiseMax(b.cwiseAbs()).cwiseMax(c.cwiseAbs());
  const Real width = widest.x() > widest.y() ? widest.x() : widest.y();
  const Real size = width + 2 * widest.z() * std::abs(view.along_z);
  const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * size;
  if (std::abs(sum) <= width * (width / Real(16) + rounding))
  {
    bc = difference_of_products(b.x(), c.y(), b.y(), c.x());
    ca = difference_of_products(c.x(), a.y(), c.y(), a.x());
    ab = difference_of_products(a.x(), b.y(), a.y(), b.x());
    sum = ab + bc + ca;
    if (std::abs(sum) <= rounding * width)
    {
      const LineSpan<Real> met = span_edge_on<Real>(a, b, c, sum, zero);
      return met.first <= met.last ? span_edge_on<Real>(a, b, c, sum, rounding) : met;
    }
  }
  const Real t = (bc * a.z() + ca * b.z() + ab * c.z()) / sum;
  return {t, t, sum};
}
// [span_of]

// [cast_triangle]
/// A triangle's unit normal on the side that a path comes from; against the path if it has none.
template <class Real>
Vector3<Real> facing_normal(
    const CastPath<Real>& path, const ShearedView<Real>& view, const Triangle<Real>& triangle,
    const Real& facing)
{
  if (facing == Real(0) || path.direction.isZero(0))
  {
    return hit_from_inside(path).normal;
  }
  const Vector3<Real> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const bool along = (facing > Real(0)) == (view.along_z > Real(0));
  const Vector3<Real> normal = along ? ac.cross(ab) : ab.cross(ac);
  return normal.isZero(0) ? hit_from_inside(path).normal : normalize<Real>(normal).unit;
}

/// Where a path first meets a triangle, from either side.
template <class Real>
std::optional<Hit<Real, 3>> first_hit_on(const CastPath<Real>& path, const Triangle<Real>& triangle)
{
  const ShearedView<Real> view = sheared_view(path);
  const LineSpan<Real> span = span_of<Real>(
      view, seen_along(view, triangle.a), seen_along(view, triangle.b),
      seen_along(view, triangle.c));
  const bool moves = !path.direction.isZero(0), holds_origin = span.first <= Real(0);
  if (!(span.first <= span.last) || !(span.last >= Real(0)) || !(moves || holds_origin))
  {
    return std::nullopt;
  }
  const Vector3<Real> normal = facing_normal(path, view, triangle, span.certain_facing());
  return hit_at<Real>(path, holds_origin ? Real(0) : span.first, normal);
}
// [cast_triangle]

} // namespace cookbook
