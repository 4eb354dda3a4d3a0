#pragma once

/// \file
/// \brief A solid made of triangles that grows by one corner at a time, in place.

#include "04_obb_manifolds/gjk_epa/gjk.hpp"
#include "common/math/norm.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace cookbook
{

// [polytope]
/// A triangle of a polytope.
template <class Real>
struct PolytopeFace
{
  std::array<int, 3> corners; ///< counter-clockwise from outside
  Vector3<Real> normal;       ///< [1], unit, outward by the order of the corners; zero where flat
  Real distance; ///< [m], along the normal from the origin; negative where it is outside
  bool done;     ///< no corner was found beyond it, or it is flat
};

/// The most corners that a polytope has room for: a tetrahedron's and one for each step.
inline constexpr std::size_t most_corners = 4 + 64;

/// The most faces: twice the corners less four close a solid of triangles.
inline constexpr std::size_t most_faces = 2 * most_corners - 4;

/// Corners and triangles that close a solid; what is beyond the counts is not set.
template <class Real>
struct Polytope
{
  std::array<SupportPoint<Real>, most_corners> corners;
  std::array<PolytopeFace<Real>, most_faces> faces;
  std::size_t corner_count = 0;
  std::size_t face_count = 0;

  /// The i-th corner of a face.
  const SupportPoint<Real>& corner(const PolytopeFace<Real>& face, std::size_t i) const
  {
    return corners[static_cast<std::size_t>(face.corners[i])];
  }
};
// [polytope]

// [add_face]
/// Adds a triangle with its plane; one thinner than `tolerance` [m] is flat and done.
///
/// Its distance is that of the closest of the three corners: a normal that rounding has tilted then
/// brings the face up for trial too early, never too late.
template <class Real>
void add_face(Polytope<Real>& polytope, const std::array<int, 3>& corners, Real tolerance)
{
  PolytopeFace<Real>& face = polytope.faces[polytope.face_count++];
  face.corners = corners;
  const Vector3<Real>& p = polytope.corner(face, 0).point;
  const Vector3<Real>& q = polytope.corner(face, 1).point;
  const Vector3<Real>& r = polytope.corner(face, 2).point;
  const Direction<Real> out = normalize<Real>((q - p).cross(r - p), Vector3<Real>::Zero());
  const Real longest =
      std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
  face.done = out.length * out.length <= tolerance * tolerance * longest;
  face.normal = face.done ? Vector3<Real>::Zero() : out.unit;
  face.distance = std::min({face.normal.dot(p), face.normal.dot(q), face.normal.dot(r)});
}
// [add_face]

// [add_corner]
/// The edges between faces that see a point and faces that do not, each as the removed face had it.
struct Horizon
{
  std::array<std::array<int, 2>, most_faces> edges;
  std::size_t count = 0;

  /// Adds an edge of a face, or takes it out where the face on its other side had it already.
  /// False where there is no room.
  bool toggle(int from, int to)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (edges[i] == std::array<int, 2>{to, from})
      {
        edges[i] = edges[--count];
        return true;
      }
    }
    if (count == edges.size())
    {
      return false;
    }
    edges[count++] = {from, to};
    return true;
  }
};

/// Whether a point is more than `tolerance` [m] beyond a face.
template <class Real>
bool sees(const Vector3<Real>& point, const PolytopeFace<Real>& face, Real tolerance)
{
  return face.normal.dot(point) - face.distance > tolerance;
}

/// Grows the polytope to hold a point: the faces that see it give way to a cone from it to the
/// edges around them. False, and nothing done, where there is no room.
template <class Real>
bool add_corner(Polytope<Real>& polytope, const SupportPoint<Real>& corner, Real tolerance)
{
  Horizon horizon;
  std::size_t seen = 0;
  for (std::size_t f = 0; f < polytope.face_count; ++f)
  {
    if (!sees(corner.point, polytope.faces[f], tolerance))
    {
      continue;
    }
    ++seen;
    const std::array<int, 3>& c = polytope.faces[f].corners;
    if (!horizon.toggle(c[0], c[1]) || !horizon.toggle(c[1], c[2]) || !horizon.toggle(c[2], c[0]))
    {
      return false;
    }
  }
  if (polytope.corner_count == most_corners ||
      polytope.face_count - seen + horizon.count > most_faces)
  {
    return false;
  }
  const auto sees_it = [&](const PolytopeFace<Real>& face)
  { return sees(corner.point, face, tolerance); };
  const auto faces = polytope.faces.begin();
  polytope.face_count = static_cast<std::size_t>(
      std::remove_if(faces, faces + std::ptrdiff_t(polytope.face_count), sees_it) - faces);
  const int top = static_cast<int>(polytope.corner_count);
  polytope.corners[polytope.corner_count++] = corner;
  for (std::size_t e = 0; e < horizon.count; ++e)
  {
    add_face<Real>(polytope, {horizon.edges[e][0], horizon.edges[e][1], top}, tolerance);
  }
  return true;
}
// [add_corner]

} // namespace cookbook
