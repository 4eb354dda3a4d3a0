#pragma once

/// \file
/// \brief Points, segments, triangles and tetrahedra, and their part that is closest to the origin.

#include "04_obb_manifolds/gjk_epa/minkowski_difference.hpp"

#include <array>

namespace cookbook
{

/// Up to four points of a solid: a point, a segment, a triangle or a tetrahedron.
template <class Real>
struct Simplex
{
  std::array<SupportPoint<Real>, 4> points; ///< `size` of them
  int size = 0;                             ///< 0 … 4

  /// Adds a point; there must be room for it.
  void add(const SupportPoint<Real>& point) { points[static_cast<std::size_t>(size++)] = point; }

  /// The i-th point of the solid.
  const Vector3<Real>& at(int i) const { return points[static_cast<std::size_t>(i)].point; }
};

/// The part of a simplex that is closest to the origin.
template <class Real>
struct NearestPart
{
  std::array<int, 3> keep; ///< `size` indices of points
  int size;                ///< 1 … 3, or 0: a tetrahedron that holds the origin
  Vector3<Real> point;     ///< [m], the closest point; zero where held
};

/// The part whose closest point is closer.
template <class Real>
NearestPart<Real> closer(const NearestPart<Real>& one, const NearestPart<Real>& other)
{
  return other.point.squaredNorm() < one.point.squaredNorm() ? other : one;
}

// [nearest_part]
/// The part of the segment from point i to point j that is closest to the origin.
template <class Real>
NearestPart<Real> nearest_of_segment(const Simplex<Real>& simplex, int i, int j)
{
  const Vector3<Real>&p = simplex.at(i), &q = simplex.at(j);
  const Vector3<Real> along = q - p;
  const Real projection = -p.dot(along), whole = along.squaredNorm();
  if (!(projection > Real(0)))
  {
    return {{i, i, i}, 1, p};
  }
  if (!(projection < whole))
  {
    return {{j, j, j}, 1, q};
  }
  return {{i, j, j}, 2, p + projection / whole * along};
}

/// The part of a triangle: its inside, or the closest of the edges that have the origin beyond.
template <class Real>
NearestPart<Real> nearest_of_triangle(const Simplex<Real>& simplex, const std::array<int, 3>& t)
{
  const Vector3<Real>& p = simplex.at(t[0]);
  const Vector3<Real> normal = (simplex.at(t[1]) - p).cross(simplex.at(t[2]) - p);
  const Real squared = normal.squaredNorm();
  NearestPart<Real> nearest{t, 3, Vector3<Real>::Zero()};
  bool beyond = !(squared > Real(0));
  for (std::size_t k = 0; k < 3; ++k)
  {
    const int i = t[k], j = t[(k + 1) % 3];
    const Vector3<Real> outward = (simplex.at(j) - simplex.at(i)).cross(normal);
    if (!(squared > Real(0)) || outward.dot(simplex.at(i)) < Real(0))
    {
      const NearestPart<Real> edge = nearest_of_segment(simplex, i, j);
      nearest = nearest.size < 3 ? closer(nearest, edge) : edge;
      beyond = true;
    }
  }
  nearest.point = beyond ? nearest.point : Vector3<Real>(normal.dot(p) / squared * normal);
  return nearest;
}

/// The part of a tetrahedron: nothing where it holds the origin, or the closest of the faces that
/// have the origin on them or beyond.
template <class Real>
NearestPart<Real> nearest_of_tetrahedron(const Simplex<Real>& simplex)
{
  NearestPart<Real> nearest{{0, 0, 0}, 0, Vector3<Real>::Zero()};
  for (int opposite = 0; opposite < 4; ++opposite)
  {
    const int i = (opposite + 1) % 4, j = (opposite + 2) % 4, k = (opposite + 3) % 4;
    const Vector3<Real>& p = simplex.at(i);
    const Vector3<Real> normal = (simplex.at(j) - p).cross(simplex.at(k) - p);
    if (-normal.dot(p) * normal.dot(simplex.at(opposite) - p) > Real(0))
    {
      continue;
    }
    const NearestPart<Real> face = nearest_of_triangle(simplex, {i, j, k});
    nearest = nearest.size == 0 ? face : closer(face, nearest);
  }
  return nearest;
}

/// The part of a simplex that is closest to the origin.
template <class Real>
NearestPart<Real> nearest_part(const Simplex<Real>& simplex)
{
  switch (simplex.size)
  {
  case 1:
    return {{0, 0, 0}, 1, simplex.at(0)};
  case 2:
    return nearest_of_segment(simplex, 0, 1);
  case 3:
    return nearest_of_triangle(simplex, {0, 1, 2});
  default:
    return nearest_of_tetrahedron(simplex);
  }
}
// [nearest_part]

} // namespace cookbook
