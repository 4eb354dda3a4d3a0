#pragma once

/// \file
/// \brief Where EPA begins: a tetrahedron from whatever GJK has left.

#include "04_obb_manifolds/gjk_epa/polytope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{

// [expansion]
/// A polytope on its way to a solid's closest face, and the best direction tried so far.
template <class Real>
struct Expansion
{
  Polytope<Real> polytope;
  Vector3<Real> normal;                          ///< [1], unit; the best direction
  Real depth = std::numeric_limits<Real>::max(); ///< [m], how far the solid extends along it
  SupportPoint<Real> found;                      ///< the support point along it
  Real tolerance;                                ///< [m], lengths that differ by less are equal
  int steps = 0;                                 ///< directions tried
  bool closed = false; ///< the best direction is the normal of a face within tolerance
};

/// The farthest point along a unit direction, which becomes the best if it extends least.
template <class Real, class Support>
SupportPoint<Real>
try_direction(Expansion<Real>& expansion, const Support& support, const Vector3<Real>& unit)
{
  SupportPoint<Real> found = support(unit);
  const Real extent = unit.dot(found.point);
  ++expansion.steps;
  if (extent < expansion.depth)
  {
    expansion.normal = unit;
    expansion.depth = extent;
    expansion.found = found;
  }
  return found;
}
// [expansion]

// [rebuild]
/// How far a point is from the line or plane through the points of a simplex [m].
template <class Real>
Real height_over(const Simplex<Real>& simplex, const Vector3<Real>& point)
{
  using std::abs;
  const Vector3<Real> p = point - simplex.at(0);
  if (simplex.size == 1)
  {
    return normalize(p).length;
  }
  const Vector3<Real> q = simplex.at(1) - simplex.at(0);
  if (simplex.size == 2)
  {
    return normalize<Real>(p.cross(normalize(q).unit)).length;
  }
  return abs(normalize<Real>(q.cross(simplex.at(2) - simplex.at(0))).unit.dot(p));
}

/// Directions out of a point, a line or a plane through the points of a simplex: each [1], unit,
/// to be tried both ways; how many.
template <class Real>
int ways_out(const Simplex<Real>& simplex, std::array<Vector3<Real>, 3>& ways)
{
  if (simplex.size == 1)
  {
    ways = {Vector3<Real>::UnitX(), Vector3<Real>::UnitY(), Vector3<Real>::UnitZ()};
    return 3;
  }
  const Vector3<Real> along = normalize<Real>(simplex.at(1) - simplex.at(0)).unit;
  if (simplex.size == 2)
  {
    int least = 0;
    along.cwiseAbs().minCoeff(&least);
    ways[0] = normalize<Real>(along.cross(Vector3<Real>::Unit(least))).unit;
    ways[1] = along.cross(ways[0]);
    return 2;
  }
  ways[0] = normalize<Real>(along.cross(simplex.at(2) - simplex.at(0))).unit;
  return 1;
}

/// A tetrahedron from what GJK left: its points as far as they are not flat, then the farthest out
/// of the line or plane. Three points or fewer where the solid itself is flat.
template <class Real, class Support>
Simplex<Real>
rebuilt(Expansion<Real>& expansion, const Support& support, const Simplex<Real>& simplex)
{
  using std::sqrt;
  Simplex<Real> solid;
  const Real fat = sqrt(std::numeric_limits<Real>::epsilon()) * normalize(simplex.at(0)).length;
  for (int i = 0; i < simplex.size; ++i)
  {
    if (i == 0 || height_over(solid, simplex.at(i)) > fat)
    {
      solid.add(simplex.points[static_cast<std::size_t>(i)]);
    }
  }
  while (solid.size < 4)
  {
    std::array<Vector3<Real>, 3> ways;
    const int count = 2 * ways_out(solid, ways);
    SupportPoint<Real> highest = solid.points[0];
    for (int way = 0; way < count; ++way)
    {
      const Vector3<Real> out =
          ways[static_cast<std::size_t>(way / 2)] * (way % 2 == 0 ? Real(1) : Real(-1));
      const SupportPoint<Real> found = try_direction(expansion, support, out);
      const bool higher = height_over(solid, found.point) > height_over(solid, highest.point);
      highest = higher ? found : highest;
    }
    if (!(height_over(solid, highest.point) > expansion.tolerance))
    {
      break;
    }
    solid.add(highest);
  }
  return solid;
}
// [rebuild]

/// An expansion that starts from what GJK left; without a face where the solid is flat.
template <class Real, class Support>
Expansion<Real>
start_expansion(const Support& support, const Simplex<Real>& simplex, Real tolerance)
{
  Expansion<Real> expansion;
  expansion.normal = Vector3<Real>::UnitX();
  expansion.found = simplex.points[0];
  expansion.tolerance = tolerance;
  const Simplex<Real> solid = rebuilt(expansion, support, simplex);
  if (solid.size < 4)
  {
    return expansion;
  }
  Polytope<Real>& polytope = expansion.polytope;
  std::copy(solid.points.begin(), solid.points.end(), polytope.corners.begin());
  polytope.corner_count = 4;
  const Vector3<Real> up = (solid.at(1) - solid.at(0)).cross(solid.at(2) - solid.at(0));
  const bool above = up.dot(solid.at(3) - solid.at(0)) > Real(0);
  const int i = above ? 2 : 1, j = above ? 1 : 2;
  for (const std::array<int, 3>& corners :
       {std::array{0, i, j}, std::array{0, j, 3}, std::array{j, i, 3}, std::array{i, 0, 3}})
  {
    add_face(polytope, corners, tolerance);
  }
  return expansion;
}

} // namespace cookbook
