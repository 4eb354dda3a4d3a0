#pragma once

/// \file
/// \brief Where two segments are closest.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"

namespace cookbook
{

// [closest_shares]
/// How far along each of two segments, 0 to 1, they are closest, and the way between there.
template <class Real>
struct ClosestShares
{
  Real on_a;         ///< [1], the point of A is start + on_a (end − start)
  Real on_b;         ///< [1], the same of B
  Vector3<Real> way; ///< [m], from the point of B to that of A
};

/// The one whose way is shorter; the first where they are equally long.
template <class Real>
ClosestShares<Real> shorter_of(const ClosestShares<Real>& one, const ClosestShares<Real>& other)
{
  return other.way.squaredNorm() < one.way.squaredNorm() ? other : one;
}

/// From the point `a` to the segment B; `on_a` is where `a` is on A.
template <class Real>
ClosestShares<Real> from_end_of_a(Real on_a, const Vector3<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> ends[] = {b.start - a, b.end - a};
  const Nearest<Real> nearest = nearest_on_segment(ends, 0, 1);
  return {on_a, nearest.shares[1], -nearest.point};
}

/// From the point `b` to the segment A; `on_b` is where `b` is on B.
template <class Real>
ClosestShares<Real> from_end_of_b(Real on_b, const Vector3<Real>& b, const Segment<Real>& a)
{
  const Vector3<Real> ends[] = {a.start - b, a.end - b};
  const Nearest<Real> nearest = nearest_on_segment(ends, 0, 1);
  return {nearest.shares[1], on_b, nearest.point};
}

/// From where the lines of two segments are closest, beyond an end of A or B: the closest point of
/// B to that of A, and where it is an end, the closest of A to it.
template <class Real>
ClosestShares<Real>
from_line_of_a(const Real& share, const Segment<Real>& a, const Segment<Real>& b)
{
  const Real zero(0), one(1), on_a = share > zero ? (share < one ? share : one) : zero;
  const Vector3<Real> there = on_a < one ? a.start + on_a * (a.end - a.start) : a.end;
  const ClosestShares<Real> nearest = from_end_of_a<Real>(on_a, there, b);
  const bool is_end = nearest.on_b == zero || nearest.on_b == one;
  return is_end ? from_end_of_b<Real>(nearest.on_b, nearest.on_b == zero ? b.start : b.end, a)
                : nearest;
}
// [closest_shares]

// [closest_segments]
/// Where two segments are closest, of any length and direction; P14.
///
/// Inside both where the lines cross there, or at an end. Of segments that are parallel, or nearly
/// so, all four ends are asked. Parallel ones have many closest points: the answer is the first of
/// A's start, A's end, B's start and B's end.
template <class Real>
[[gnu::flatten]] ClosestShares<Real> closest_shares(const Segment<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> along_a = a.end - a.start, along_b = b.end - b.start;
  const Vector3<Real> between = b.start - a.start;
  const Vector3<Real> normal = along_a.cross(along_b);
  const Real squared = normal.squaredNorm();
  const Real on_a = between.cross(along_b).dot(normal), on_b = between.cross(along_a).dot(normal);
  const bool is_thin =
      !(squared > thin_squared_sine<Real> * along_a.squaredNorm() * along_b.squaredNorm());
  const bool cross =
      squared > Real(0) && on_a > Real(0) && on_a < squared && on_b > Real(0) && on_b < squared;
  if (!is_thin && !cross)
  {
    return from_line_of_a(on_a / squared, a, b);
  }
  ClosestShares<Real> inside{Real(0), Real(0), -between};
  if (cross)
  {
    inside.on_a = on_a / squared;
    inside.on_b = on_b / squared;
    inside.way = inside.on_a * along_a - between - inside.on_b * along_b;
    if (!is_thin)
    {
      // Once more, for a short way: rounding has left some of it along the segments.
      inside.way = inside.way.dot(normal) / squared * normal;
      return inside;
    }
  }
  ClosestShares<Real> nearest = from_end_of_a<Real>(Real(0), a.start, b);
  nearest = shorter_of(nearest, from_end_of_a<Real>(Real(1), a.end, b));
  nearest = shorter_of(nearest, from_end_of_b<Real>(Real(0), b.start, a));
  nearest = shorter_of(nearest, from_end_of_b<Real>(Real(1), b.end, a));
  return cross ? shorter_of(nearest, inside) : nearest;
}
// [closest_segments]

} // namespace cookbook
