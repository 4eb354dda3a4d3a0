#pragma once

/// \file
/// \brief EPA: the face of a convex solid, known by its support function, closest to the origin.

#include "04_obb_manifolds/gjk_epa/epa_start.hpp"

#include <algorithm>

namespace cookbook
{

// [expand]
/// The index of the face closest to the origin that is not done; `face_count` if there is none.
template <class Real>
std::size_t closest_face(const Polytope<Real>& polytope)
{
  std::size_t closest = polytope.face_count;
  for (std::size_t f = 0; f < polytope.face_count; ++f)
  {
    const bool first = closest == polytope.face_count;
    if (!polytope.faces[f].done &&
        (first || polytope.faces[f].distance < polytope.faces[closest].distance))
    {
      closest = f;
    }
  }
  return closest;
}

/// Tries the normal of the closest face: false where no step can follow.
///
/// A face that the solid does not reach beyond, but for tolerance, is the closest of the solid:
/// closed. The end too: no face left to try, no room for a corner.
template <class Real, class Support>
bool expand(Expansion<Real>& expansion, const Support& support)
{
  Polytope<Real>& polytope = expansion.polytope;
  const std::size_t closest = closest_face(polytope);
  if (closest == polytope.face_count)
  {
    return false;
  }
  PolytopeFace<Real>& face = polytope.faces[closest];
  const Vector3<Real> normal = face.normal;
  const SupportPoint<Real> found = try_direction(expansion, support, normal);
  const Real extent = normal.dot(found.point);
  if (extent - face.distance <= expansion.tolerance)
  {
    const bool best = extent <= expansion.depth + expansion.tolerance;
    expansion.normal = best ? normal : expansion.normal;
    expansion.depth = best ? extent : expansion.depth;
    expansion.closed = true;
    return false;
  }
  const auto last = polytope.corners.begin() + std::ptrdiff_t(polytope.corner_count);
  const auto is_it = [&](const SupportPoint<Real>& c) { return c.point == found.point; };
  face.done = std::any_of(polytope.corners.begin(), last, is_it);
  return face.done || add_corner(polytope, found, expansion.tolerance);
}
// [expand]

// [epa]
/// The most directions that epa() tries; boxes need fewer, round solids may never close.
inline constexpr int epa_limit = 64;

/// Grows a polytope inside the solid, corner by corner, towards its face closest to the origin,
/// O18.
///
/// `simplex` may be anything that gjk() left, also flat: it is rebuilt, and whether the origin is
/// inside it does not matter, since faces know by the order of their corners where out is. At the
/// limit the best direction so far is the answer, `closed` is false, and `depth` is an upper bound:
/// moving that far along `normal` separates the shapes. A negative depth: `normal` separates them.
template <class Real, class Support>
Expansion<Real> epa(const Support& support, const Simplex<Real>& simplex, Real tolerance)
{
  Expansion<Real> expansion = start_expansion(support, simplex, tolerance);
  while (!(expansion.depth < Real(0)) && expansion.steps < epa_limit && expand(expansion, support))
  {
  }
  return expansion;
}
// [epa]

} // namespace cookbook
