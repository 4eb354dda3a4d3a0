#pragma once

/// \file
/// \brief The polygon in which two facing rectangles overlap, four edges at a time.

#include "common/simd/group.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [facing_rectangles]
/// A rectangle in its own plane, |u| ≤ half_u and |v| ≤ half_v, and another that faces it.
///
/// The other's points are center + α p + β q with |α|, |β| ≤ 1; in the plane they fill a
/// parallelogram.
template <class Real>
struct FacingRectangles
{
  Real half_u, half_v;                 ///< [m]
  Real center_u, center_v;             ///< [m]
  Real p_u, p_v;                       ///< [m]
  Real q_u, q_v;                       ///< [m], to the left of p
  Real half_p, half_q;                 ///< [m], the lengths of p and q
  Real center_depth, p_depth, q_depth; ///< [m], how deep under the plane: affine in α and β
};

/// Four points of the plane, those that are corners of the overlap, and their depths.
template <class Real>
struct FourCorners
{
  using Row = Group<Real, 4>;

  Row u, v, depth;          ///< [m]
  typename Row::Mask there; ///< whether it is a corner
};
// [facing_rectangles]

// [pieces]
/// Round a parallelogram: p, q, −p and −q.
template <class Real>
Group<Real, 4> round(const Real& p, const Real& q)
{
  return group<Real>(p, q, p, q) * group<Real>(Real(1), Real(1), Real(-1), Real(-1));
}

/// 1/x, but no larger than 1/least.
template <class Number>
Number bounded_reciprocal(const Number& x, const Number& least)
{
  using std::abs;
  return Number(1) / select(abs(x) < least, least, x);
}

/// The pieces of the four edges of a parallelogram that lie in two strips; an edge runs from 0
/// to 1.
template <class Real>
struct Pieces
{
  using Row = Group<Real, 4>;

  Row enter = Row(Real(0));  ///< where each edge comes in
  Row leave = Row(Real(1));  ///< where it goes out
  Row corner = Row(Real(0)); ///< where its corner is: `enter`, not moved by the tie

  /// Cuts off what lies outside |x| ≤ half + tie, where x is `start` at the edges' beginnings and
  /// grows by p, q, −p and −q along them; steps shorter than `least` count as that long.
  ///
  /// The tie decides whether there is a corner; it moves none, but where an edge runs along the
  /// strip's, so that there the corner is the tie's own.
  void
  cut(const Row& start, const Real& p, const Real& q, const Real& half, const Real& tie,
      const Real& least)
  {
    using std::max;
    const Row per_step = bounded_reciprocal(group<Real>(p, q, p, q), Row(least));
    const Row per_length = abs(per_step), middle = start * per_step * round(Real(-1), Real(-1));
    const Row reach = Row(max(half + tie, Real(0))) * per_length;
    const Row first = middle - reach, shift = Row(tie) * per_length;
    enter = max(enter, first);
    leave = min(leave, middle + reach);
    corner = max(corner, first + select(abs(shift) < Row(Real(1e-3f)), shift, Row(Real(0))));
  }
};
// [pieces]

// [corners]
/// Where on the edges of a parallelogram: at `start`, and on by a part of p, q, −p and −q.
template <class Real>
Group<Real, 4>
along(const Group<Real, 4>& start, const Group<Real, 4>& part, const Real& p, const Real& q)
{
  return start + part * round(p, q);
}

/// The corners of a parallelogram, each the beginning of an edge: p, q, −p, −q lead round it.
template <class Real>
Group<Real, 4> corners(const Real& center, const Real& p, const Real& q)
{
  using Row = Group<Real, 4>;
  const Real one(1);
  return Row(center) + Row(p) * group<Real>(-one, one, one, -one) +
         Row(q) * group<Real>(-one, -one, one, one);
}

/// Corners at which a piece of the other's edges begins; a hair outside this rectangle counts as in
/// it.
template <class Real>
FourCorners<Real> corners_on_other(const FacingRectangles<Real>& r, const Real& hair)
{
  using Row = Group<Real, 4>;
  const Row u = corners<Real>(r.center_u, r.p_u, r.q_u);
  const Row v = corners<Real>(r.center_v, r.p_v, r.q_v);
  const Row depth = corners<Real>(r.center_depth, r.p_depth, r.q_depth);
  const Real least = hair * Real(1e-6f);
  const auto twice = [](const Real& x) { return x + x; };
  Pieces<Real> pieces;
  pieces.cut(u, twice(r.p_u), twice(r.q_u), r.half_u, hair, least);
  pieces.cut(v, twice(r.p_v), twice(r.q_v), r.half_v, hair, least);
  const Row part = pieces.corner + pieces.corner;
  return {
      along<Real>(u, part, r.p_u, r.q_u), along<Real>(v, part, r.p_v, r.q_v),
      along<Real>(depth, part, r.p_depth, r.q_depth), pieces.enter < pieces.leave};
}

/// Corners at which a piece of this rectangle's edges begins; a hair inside the other counts as
/// out.
///
/// There α and β are measured in areas: multiplied by that of p and q, they need no division.
template <class Real>
FourCorners<Real> corners_on_this(const FacingRectangles<Real>& r, const Real& hair)
{
  using Row = Group<Real, 4>;
  const Real least = hair * hair;
  const Real zero(0), area = r.p_u * r.q_v - r.p_v * r.q_u;
  const Row u = corners<Real>(zero, r.half_u, zero), v = corners<Real>(zero, zero, r.half_v);
  const Row from_u = u - Row(r.center_u), from_v = v - Row(r.center_v);
  const Row alpha = from_u * Row(r.q_v) - from_v * Row(r.q_u);
  const Row beta = from_v * Row(r.p_u) - from_u * Row(r.p_v);
  const Real side_u = r.half_u + r.half_u, side_v = r.half_v + r.half_v;
  const Real alpha_p = side_u * r.q_v, alpha_q = -side_v * r.q_u;
  const Real beta_p = -side_u * r.p_v, beta_q = side_v * r.p_u;
  Pieces<Real> pieces;
  pieces.cut(alpha, alpha_p, alpha_q, area, -hair * r.half_q, least);
  pieces.cut(beta, beta_p, beta_q, area, -hair * r.half_p, least);
  const Real per_area = bounded_reciprocal(area, least);
  const Real p_slope = r.p_depth * per_area, q_slope = r.q_depth * per_area;
  const Row depth = Row(r.center_depth) + alpha * Row(p_slope) + beta * Row(q_slope);
  return {
      along<Real>(u, pieces.corner, side_u, zero), along<Real>(v, pieces.corner, zero, side_v),
      along<Real>(
          depth, pieces.corner, alpha_p * p_slope + beta_p * q_slope,
          alpha_q * p_slope + beta_q * q_slope),
      pieces.enter < pieces.leave};
}
// [corners]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
