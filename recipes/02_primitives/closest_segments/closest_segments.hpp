#pragma once

/// \file
/// \brief Where two segments are closest.

#include "02_primitives/closest_point_triangle/closest_point_triangle.hpp"
#include "common/math/norm.hpp"

namespace cookbook
{

// [closest_fractions]
/// How far along each of two segments, 0 to 1, they are closest, and the way between there.
template <class Real>
struct ClosestFractions
{
  Real on_a;                ///< [1], the point of A is start + on_a (end − start)
  Real on_b;                ///< [1], the same of B
  Vector3<Real> difference; ///< [m], from the point of B to that of A
};

/// The one whose way is shorter; the first where they are equally long.
template <class Real>
ClosestFractions<Real>
shorter_of(const ClosestFractions<Real>& one, const ClosestFractions<Real>& other)
{
  return other.difference.squaredNorm() < one.difference.squaredNorm() ? other : one;
}

/// From the point `a` to the segment B; `on_a` is where `a` is on A.
template <class Real>
ClosestFractions<Real> from_end_of_a(Real on_a, const Vector3<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> ends[] = {b.start - a, b.end - a};
  const Nearest<Real> nearest = nearest_on_segment(ends, 0, 1);
  return {on_a, nearest.weights[1], -nearest.point};
}

/// From the point `b` to the segment A; `on_b` is where `b` is on B.
template <class Real>
ClosestFractions<Real> from_end_of_b(Real on_b, const Vector3<Real>& b, const Segment<Real>& a)
{
  const Vector3<Real> ends[] = {a.start - b, a.end - b};
  const Nearest<Real> nearest = nearest_on_segment(ends, 0, 1);
  return {nearest.weights[1], on_b, nearest.point};
}

/// A way counts as short if its square is below this fraction of the squares of both segments.
template <class Real>
inline const Real short_squared_ratio = Real(1) / Real(10'000);

/// A way much shorter than its segments is a small difference of large numbers: once more, from
/// the end that it leads to, or along the normal of both.
template <class Real>
[[gnu::noinline, gnu::cold]] ClosestFractions<Real> fractions_where_close(
    ClosestFractions<Real> at, const Segment<Real>& a, const Segment<Real>& b,
    const Vector3<Real>& normal)
{
  const Real zero(0), one(1);
  if (at.on_a == zero || at.on_a == one)
  {
    return from_end_of_a<Real>(at.on_a, at.on_a == zero ? a.start : a.end, b);
  }
  if (at.on_b == zero || at.on_b == one)
  {
    return from_end_of_b<Real>(at.on_b, at.on_b == zero ? b.start : b.end, a);
  }
  const Vector3<Real> unit = normalize<Real>(normal).unit;
  at.difference = at.difference.dot(unit) * unit;
  return at;
}
// [closest_fractions]

// [closest_in_turn]
/// From where the lines are closest on A to the closest point of B, and where this is an end, back
/// to A; P14. For segments that are not parallel.
template <class Real>
ClosestFractions<Real> closest_in_turn(const Segment<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> along_a = a.end - a.start, along_b = b.end - b.start;
  const Vector3<Real> between = b.start - a.start, normal = along_a.cross(along_b);
  const Real whole_a = along_a.squaredNorm(), whole_b = along_b.squaredNorm();
  // Reciprocals need not wait for each other, as divisions below would.
  const Real per_a = Real(1) / whole_a, per_b = Real(1) / whole_b, both = along_a.dot(along_b);
  const Real on_line =
      clamped_fraction<Real>(between.cross(along_b).dot(normal) / normal.squaredNorm());
  const Real on_b = clamped_fraction<Real>((on_line * both - between.dot(along_b)) * per_b);
  const Real back = clamped_fraction<Real>((on_b * both + between.dot(along_a)) * per_a);
  const Real on_a = on_b > Real(0) && on_b < Real(1) ? on_line : back;
  const ClosestFractions<Real> at{on_a, on_b, on_a * along_a - between - on_b * along_b};
  const bool is_short =
      at.difference.squaredNorm() < short_squared_ratio<Real> * (whole_a + whole_b);
  return is_short ? fractions_where_close(at, a, b, normal) : at;
}
// [closest_in_turn]

// [closest_segments]
/// Of segments that are parallel, or nearly so, the closest of all four ends, unless shares are
/// closer still.
template <class Real>
[[gnu::noinline, gnu::cold]] ClosestFractions<Real>
closest_of_parallel(const Segment<Real>& a, const Segment<Real>& b)
{
  ClosestFractions<Real> nearest = from_end_of_a<Real>(Real(0), a.start, b);
  nearest = shorter_of(nearest, from_end_of_a<Real>(Real(1), a.end, b));
  nearest = shorter_of(nearest, from_end_of_b<Real>(Real(0), b.start, a));
  nearest = shorter_of(nearest, from_end_of_b<Real>(Real(1), b.end, a));
  const bool can_cross = (a.end - a.start).cross(b.end - b.start).squaredNorm() > Real(0);
  return can_cross ? shorter_of(nearest, closest_in_turn(a, b)) : nearest;
}

/// Where two segments are closest, of any length and direction; sizes from 1e-70 to 1e70 in double.
///
/// Parallel ones have many closest points: the answer is the first of A's start, A's end, B's start
/// and B's end.
template <class Real>
[[gnu::flatten]] ClosestFractions<Real>
closest_fractions(const Segment<Real>& a, const Segment<Real>& b)
{
  const Vector3<Real> along_a = a.end - a.start, along_b = b.end - b.start;
  const Real whole = along_a.squaredNorm() * along_b.squaredNorm();
  const bool is_thin = !(along_a.cross(along_b).squaredNorm() > thin_squared_sine<Real> * whole);
  return is_thin ? closest_of_parallel(a, b) : closest_in_turn(a, b);
}
// [closest_segments]

} // namespace cookbook
