#pragma once

/// \file
/// \brief Ways to run GJK and EPA that are in use and fail: kept to show where.

#include "04_obb_manifolds/gjk_epa/epa.hpp"

#include <optional>

namespace cookbook
{

/// The depth of two convex shapes as gjk_epa() finds it; nothing where they are apart.
///
/// `tolerance` [m] is what rounding may make of lengths as large as the shapes.
template <class Real, class Support>
std::optional<Real> convex_depth(const Support& support, const Vector3<Real>& start, Real tolerance)
{
  const GjkAnswer<Real> decision = gjk(support, start, tolerance);
  if (decision.apart)
  {
    return std::nullopt;
  }
  const Real depth = epa(support, decision.simplex, tolerance).depth;
  return depth < Real(0) ? std::nullopt : std::optional(depth);
}

// [absolute_tolerance]
/// Stops when the gap is a micrometre, whatever the size of the shapes, and has no answer where it
/// does not get there.
template <class Real, class Support>
std::optional<Real> absolute_tolerance(const Support& support, const Vector3<Real>& start, Real)
{
  const Real micrometre = Real(1e-6);
  const GjkAnswer<Real> decision = gjk(support, start, micrometre);
  if (decision.apart)
  {
    return std::nullopt;
  }
  const Expansion<Real> expansion = epa(support, decision.simplex, micrometre);
  return expansion.closed ? std::optional(expansion.depth) : std::nullopt;
}
// [absolute_tolerance]

// [no_rebuild]
/// Takes for a contact only what GJK leaves as a tetrahedron.
template <class Real, class Support>
std::optional<Real> no_rebuild(const Support& support, const Vector3<Real>& start, Real tolerance)
{
  const GjkAnswer<Real> decision = gjk(support, start, tolerance);
  if (decision.apart || decision.simplex.size < 4)
  {
    return std::nullopt;
  }
  return epa(support, decision.simplex, tolerance).depth;
}
// [no_rebuild]

// [two_tolerances]
/// GJK calls touching what is within a micrometre; EPA then has the distance of the closest face,
/// which has no sign.
template <class Real, class Support>
std::optional<Real>
two_tolerances(const Support& support, const Vector3<Real>& start, Real tolerance)
{
  const Real micrometre = Real(1e-6);
  const auto grown = [&](const Vector3<Real>& direction) -> SupportPoint<Real>
  {
    SupportPoint<Real> found = support(direction);
    found.point += micrometre * normalize(direction).unit;
    return found;
  };
  if (gjk(grown, start, tolerance).apart)
  {
    return std::nullopt;
  }
  using std::abs;
  return abs(epa(support, gjk(support, start, tolerance).simplex, tolerance).depth);
}
// [two_tolerances]

} // namespace cookbook
