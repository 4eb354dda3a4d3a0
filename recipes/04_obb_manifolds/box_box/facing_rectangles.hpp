#pragma once

/// \file
/// \brief The polygon in which two facing rectangles overlap, four edges at a time.

#include "common/simd/row.hpp"

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

/// How far [m] two rectangles overlap along u or along v, whichever is less.
template <class Real>
Real facing_overlap(const FacingRectangles<Real>& r)
{
  using std::abs, std::min;
  return min(
      r.half_u + (abs(r.p_u) + abs(r.q_u)) - abs(r.center_u),
      r.half_v + (abs(r.p_v) + abs(r.q_v)) - abs(r.center_v));
}

/// Four points of the plane, those that are corners of the overlap, and their depths.
template <class Four>
struct FourCorners
{
  Four u, v, depth;          ///< [m]
  typename Four::Mask there; ///< whether it is a corner
};
// [facing_rectangles]

// [pieces]
/// Round a parallelogram: p, q, −p and −q.
template <class Four, class Real>
Four round(const Real& p, const Real& q)
{
  const Real one(1), minus(-1);
  return Four(p, q, p, q) * Four(one, one, minus, minus);
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
template <class Four>
struct Pieces
{
  using Real = typename Four::Number;

  Four enter = Four(Real(0));  ///< where each edge comes in
  Four leave = Four(Real(1));  ///< where it goes out
  Four corner = Four(Real(0)); ///< where its corner is: `enter`, not moved by the tie

  /// Cuts off what lies outside |x| ≤ half + tie, where x is `start` at the edges' beginnings and
  /// grows by p, q, −p and −q along them; steps shorter than `least` count as that long.
  ///
  /// The tie decides whether there is a corner; it moves none, but where an edge runs along the
  /// strip's, so that there the corner is the tie's own.
  void
  cut(const Four& start, const Real& p, const Real& q, const Real& half, const Real& tie,
      const Real& least)
  {
    using std::max;
    const Four per_step = bounded_reciprocal(Four(p, q, p, q), Four(least));
    const Four per_length = abs(per_step),
               middle = start * per_step * round<Four>(Real(-1), Real(-1));
    const Four radius = Four(max(half + tie, Real(0))) * per_length;
    const Four first = middle - radius, shift = Four(tie) * per_length;
    enter = max(enter, first);
    leave = min(leave, middle + radius);
    corner = max(corner, first + select(abs(shift) < Four(Real(1e-3f)), shift, Four(Real(0))));
  }
};
// [pieces]

// [corners]
/// Where on the edges of a parallelogram: at `start`, and on by a part of p, q, −p and −q.
template <class Four, class Real>
Four along(const Four& start, const Four& part, const Real& p, const Real& q)
{
  return start + part * round<Four>(p, q);
}

/// The corners of a parallelogram, each the beginning of an edge: p, q, −p, −q lead round it.
template <class Four, class Real>
Four corners(const Real& center, const Real& p, const Real& q)
{
  const Real one(1);
  return Four(center) + Four(p) * Four(-one, one, one, -one) + Four(q) * Four(-one, -one, one, one);
}

/// Corners at which a piece of the other's edges begins; within `tolerance` outside this rectangle
/// counts as in it.
template <class Four, class Real>
FourCorners<Four> corners_on_other(const FacingRectangles<Real>& r, const Real& tolerance)
{
  const Four u = corners<Four>(r.center_u, r.p_u, r.q_u);
  const Four v = corners<Four>(r.center_v, r.p_v, r.q_v);
  const Four depth = corners<Four>(r.center_depth, r.p_depth, r.q_depth);
  const Real least = tolerance * Real(1e-6f);
  const auto twice = [](const Real& x) { return x + x; };
  Pieces<Four> pieces;
  pieces.cut(u, twice(r.p_u), twice(r.q_u), r.half_u, tolerance, least);
  pieces.cut(v, twice(r.p_v), twice(r.q_v), r.half_v, tolerance, least);
  const Four part = pieces.corner + pieces.corner;
  return {
      along(u, part, r.p_u, r.q_u), along(v, part, r.p_v, r.q_v),
      along(depth, part, r.p_depth, r.q_depth), pieces.enter < pieces.leave};
}

/// Corners at which a piece of this rectangle's edges begins; within `tolerance` inside the other
/// counts as out.
///
/// There α and β are measured in areas: multiplied by that of p and q, they need no division.
template <class Four, class Real>
FourCorners<Four> corners_on_this(const FacingRectangles<Real>& r, const Real& tolerance)
{
  const Real least = tolerance * tolerance;
  const Real zero(0), area = r.p_u * r.q_v - r.p_v * r.q_u;
  const Four u = corners<Four>(zero, r.half_u, zero), v = corners<Four>(zero, zero, r.half_v);
  const Four from_u = u - Four(r.center_u), from_v = v - Four(r.center_v);
  const Four alpha = from_u * Four(r.q_v) - from_v * Four(r.q_u);
  const Four beta = from_v * Four(r.p_u) - from_u * Four(r.p_v);
  const Real side_u = r.half_u + r.half_u, side_v = r.half_v + r.half_v;
  const Real alpha_p = side_u * r.q_v, alpha_q = -side_v * r.q_u;
  const Real beta_p = -side_u * r.p_v, beta_q = side_v * r.p_u;
  Pieces<Four> pieces;
  pieces.cut(alpha, alpha_p, alpha_q, area, -tolerance * r.half_q, least);
  pieces.cut(beta, beta_p, beta_q, area, -tolerance * r.half_p, least);
  const Real per_area = bounded_reciprocal(area, least);
  const Real p_slope = r.p_depth * per_area, q_slope = r.q_depth * per_area;
  const Four depth = Four(r.center_depth) + alpha * Four(p_slope) + beta * Four(q_slope);
  return {
      along(u, pieces.corner, side_u, zero), along(v, pieces.corner, zero, side_v),
      along(
          depth, pieces.corner, alpha_p * p_slope + beta_p * q_slope,
          alpha_q * p_slope + beta_q * q_slope),
      pieces.enter < pieces.leave};
}
// [corners]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
