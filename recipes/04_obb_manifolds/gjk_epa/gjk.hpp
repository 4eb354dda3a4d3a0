#pragma once

/// \file
/// \brief GJK: whether a convex solid, known by its support function, holds the origin.

#include "04_obb_manifolds/gjk_epa/simplex.hpp"

namespace cookbook
{

// [gjk]
/// What GJK came to: a direction that separates, or a simplex around the origin.
template <class Real>
struct GjkAnswer
{
  bool apart;            ///< a direction was found that separates
  Simplex<Real> simplex; ///< otherwise: holds the origin, as far as rounding and the limit let it
  int steps;             ///< support points that were asked for
};

/// The most support points that gjk() asks for; boxes need about four, ten at most.
inline constexpr int gjk_limit = 32;

/// Walks towards the origin: from a simplex to the support point towards the origin, and back to
/// the part of both that is closest to it.
///
/// `support(direction)` is the solid; `start` any direction. It says apart only for a direction
/// that separates(). The other answer is a guess where the origin is within `tolerance` [m] of the
/// simplex or the limit is reached: the simplex may then be less than a tetrahedron around the
/// origin, and what follows must not mind.
template <class Real, class Support>
GjkAnswer<Real> gjk(const Support& support, const Vector3<Real>& start, Real tolerance)
{
  GjkAnswer<Real> answer{false, {}, 1};
  answer.simplex.add(support(start));
  Vector3<Real> nearest = answer.simplex.at(0);
  while (answer.steps < gjk_limit && nearest.squaredNorm() > tolerance * tolerance)
  {
    const SupportPoint<Real> found = support(-nearest);
    ++answer.steps;
    if (separates<Real>(found.point, -nearest))
    {
      return {true, answer.simplex, answer.steps};
    }
    answer.simplex.add(found);
    const NearestPart<Real> part = nearest_part(answer.simplex);
    if (part.size == 0)
    {
      break;
    }
    Simplex<Real> kept;
    for (int i = 0; i < part.size; ++i)
    {
      kept.add(answer.simplex.points[static_cast<std::size_t>(part.keep[std::size_t(i)])]);
    }
    answer.simplex = kept;
    nearest = part.point;
  }
  return answer;
}
// [gjk]

} // namespace cookbook
