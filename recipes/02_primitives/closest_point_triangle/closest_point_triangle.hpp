#pragma once

/// \file
/// \brief The point of a segment and of a triangle that is closest to the origin, or to any point.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/wide.hpp"

namespace cookbook
{

// [nearest_part]
/// The point of a segment, a triangle or a tetrahedron that is closest to the origin.
template <class Real>
struct Nearest
{
  Vector<Real, 4> shares; ///< [1], of each corner, 0 or more, with the sum 1
  Vector3<Real> point;    ///< [m], the sum of share times corner
};

/// The one whose point is closer; the first where they are equally close.
template <class Real>
Nearest<Real> closer_of(const Nearest<Real>& one, const Nearest<Real>& other)
{
  return other.point.squaredNorm() < one.point.squaredNorm() ? other : one;
}

/// The squared sine of the angle below which a triangle counts as thin: rounding may then tell the
/// wrong side of an edge, so that the edges are asked too.
template <class Real>
inline const Real thin_squared_sine = Real(1) / Real(1'000'000'000'000);
// [nearest_part]

// [nearest_on_segment]
/// The point of the segment from corner i to corner j that is closest to the origin; P2.
///
/// Corner i where both corners are the same.
template <class Real>
Nearest<Real> nearest_on_segment(const Vector3<Real>* corners, int i, int j)
{
  const Vector3<Real>&a = corners[i], &b = corners[j];
  const Vector3<Real> along = b - a;
  const Real share = -a.dot(along), whole = along.squaredNorm();
  Nearest<Real> nearest{Vector<Real, 4>::Zero(), a};
  if (!(share > Real(0)) || !(whole > Real(0)))
  {
    nearest.shares[i] = Real(1);
  }
  else if (!(share < whole))
  {
    nearest.shares[j] = Real(1);
    nearest.point = b;
  }
  else
  {
    nearest.shares[j] = share / whole;
    nearest.shares[i] = Real(1) - nearest.shares[j];
    nearest.point = a + nearest.shares[j] * along;
    // Once more, for a short way: rounding has left some of it along the segment.
    nearest.point -= nearest.point.dot(along) / whole * along;
  }
  return nearest;
}
// [nearest_on_segment]

// [nearest_on_triangle]
/// The point of the triangle of corners i, j and k that is closest to the origin; P11, P13.
///
/// A flat triangle is its three edges.
template <class Real>
Nearest<Real> nearest_on_triangle(const Vector3<Real>* corners, int i, int j, int k)
{
  const Vector3<Real>&a = corners[i], &b = corners[j], &c = corners[k];
  const Vector3<Real> ab = b - a, bc = c - b, ca = a - c;
  const Vector3<Real> normal = ca.cross(ab);
  const Real squared = normal.squaredNorm();
  // How far the origin lies inside each edge, as a share of the corner across.
  const Vector3<Real> inside(
      normal.dot(b.cross(bc)), normal.dot(c.cross(ca)), normal.dot(a.cross(ab)));
  const bool over_face =
      squared > Real(0) && inside.x() > Real(0) && inside.y() > Real(0) && inside.z() > Real(0);
  const bool is_thin = !(squared > thin_squared_sine<Real> * ab.squaredNorm() * ca.squaredNorm());
  Nearest<Real> nearest{Vector<Real, 4>::Zero(), a};
  if (over_face)
  {
    const Vector3<Real> shares = inside / inside.sum();
    nearest.shares[i] = shares.x();
    nearest.shares[j] = shares.y();
    nearest.shares[k] = shares.z();
    nearest.point = shares.x() * a + shares.y() * b + shares.z() * c;
    if (!is_thin)
    {
      // Once more, for a short way: rounding has left some of it along the face.
      nearest.point = normal.dot(nearest.point) / squared * normal;
      return nearest;
    }
  }
  else
  {
    nearest.shares[i] = Real(1);
  }
  // The closest point lies on an edge that the origin is beyond; of a thin triangle on any.
  const auto ask = [&](const Real& how_far_inside, int from, int to)
  {
    if (is_thin || !(how_far_inside > Real(0)))
    {
      nearest = closer_of(nearest, nearest_on_segment(corners, from, to));
    }
  };
  ask(inside.z(), i, j);
  ask(inside.x(), j, k);
  ask(inside.y(), k, i);
  return nearest;
}
// [nearest_on_triangle]

} // namespace cookbook
