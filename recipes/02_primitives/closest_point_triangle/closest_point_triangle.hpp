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
  Vector<Real, 4> weights; ///< [1], of each corner, 0 or more, with the sum 1
  Vector3<Real> point;     ///< [m], the sum of share times corner, but less rounded
};

/// The one whose point is closer; the first where they are equally close.
template <class Real>
Nearest<Real> closer_of(const Nearest<Real>& one, const Nearest<Real>& other)
{
  return other.point.squaredNorm() < one.point.squaredNorm() ? other : one;
}

/// A share, but not beyond 0 and 1.
template <class Real>
Real clamped_fraction(const Real& fraction)
{
  const Real from_zero = fraction > Real(0) ? fraction : Real(0);
  return from_zero < Real(1) ? from_zero : Real(1);
}

/// Corner i alone.
template <class Real>
Nearest<Real> nearest_on_corner(const Vector3<Real>* corners, int i)
{
  Nearest<Real> nearest{Vector<Real, 4>::Zero(), corners[i]};
  nearest.weights[i] = Real(1);
  return nearest;
}

/// Whether the origin is over the face: all barycentric coordinates of its foot, in any proportion,
/// are above zero.
template <class Real>
bool is_over_face(const Vector3<Real>& weights)
{
  return weights.x() > Real(0) && weights.y() > Real(0) && weights.z() > Real(0);
}

/// The point of the plane through corners i, j and k with shares in these proportions.
template <class Real>
Nearest<Real>
nearest_on_face(const Vector3<Real>* corners, int i, int j, int k, const Vector3<Real>& proportions)
{
  const Vector3<Real> weights = proportions / proportions.sum();
  Nearest<Real> nearest{
      Vector<Real, 4>::Zero(),
      weights.x() * corners[i] + weights.y() * corners[j] + weights.z() * corners[k]};
  nearest.weights[i] = weights.x();
  nearest.weights[j] = weights.y();
  nearest.weights[k] = weights.z();
  return nearest;
}

/// A point of the triangle, moved along the edge from corner i to corner j to where it is closest,
/// but not out of the triangle.
template <class Real>
Nearest<Real> moved_along(Nearest<Real> nearest, const Vector3<Real>* corners, int i, int j)
{
  const Vector3<Real> along = corners[j] - corners[i];
  const Real fraction = nearest.point.dot(along) / along.squaredNorm();
  const Real back = fraction > nearest.weights[j]    ? nearest.weights[j]
                    : fraction < -nearest.weights[i] ? Real(-nearest.weights[i])
                                                     : fraction;
  nearest.weights[i] += back;
  nearest.weights[j] -= back;
  nearest.point -= back * along;
  return nearest;
}

/// The squared sine of the angle below which a triangle counts as thin: rounding may then tell the
/// wrong side of an edge, so that the edges are asked too.
template <class Real>
inline const Real thin_squared_sine = Real(1) / Real(1'000'000'000'000);

/// A triangle counts as narrow if the squared length of its normal is below this fraction of the
/// square of ab² + ca²: rounding may then move a point along its face.
template <class Real>
inline const Real narrow_squared_ratio = Real(1) / Real(100);
// [nearest_part]

// [nearest_on_segment]
/// The point of the line through corners i and j that is closest to the origin.
template <class Real>
Nearest<Real> nearest_on_line(const Vector3<Real>* corners, int i, int j)
{
  const Vector3<Real> along = corners[j] - corners[i];
  const Real whole = along.squaredNorm();
  const Real fraction = clamped_fraction<Real>(-corners[i].dot(along) / whole);
  Nearest<Real> nearest{Vector<Real, 4>::Zero(), corners[i] + fraction * along};
  nearest.weights[i] = Real(1) - fraction;
  nearest.weights[j] = fraction;
  // Once more, for a short way: rounding has left some of it along the line.
  nearest.point -= nearest.point.dot(along) / whole * along;
  return nearest;
}

/// The point of the segment from corner i to corner j that is closest to the origin; P2.
///
/// Corner i where both corners are the same.
template <class Real>
Nearest<Real> nearest_on_segment(const Vector3<Real>* corners, int i, int j)
{
  const Vector3<Real> along = corners[j] - corners[i];
  const Real fraction = -corners[i].dot(along), whole = along.squaredNorm();
  if (!(fraction > Real(0)) || !(whole > Real(0)))
  {
    return nearest_on_corner(corners, i);
  }
  return fraction < whole ? nearest_on_line(corners, i, j) : nearest_on_corner(corners, j);
}
// [nearest_on_segment]

// [nearest_on_thin_triangle]
/// The same of a face whose shares rounding has moved along the edges: moved back along each.
template <class Real>
Nearest<Real>
nearest_on_thin_face(const Vector3<Real>* corners, int i, int j, int k, const Vector3<Real>& inside)
{
  Nearest<Real> nearest = nearest_on_face(corners, i, j, k, inside);
  nearest = moved_along(nearest, corners, i, j);
  nearest = moved_along(nearest, corners, j, k);
  return moved_along(nearest, corners, k, i);
}

/// Where rounding may tell the wrong side of an edge, the edges are asked, too.
template <class Real>
[[gnu::noinline, gnu::cold]] Nearest<Real> nearest_on_thin_triangle(
    const Vector3<Real>* corners, int i, int j, int k, const Vector3<Real>& inside)
{
  const Nearest<Real> edge = closer_of(
      closer_of(nearest_on_segment(corners, i, j), nearest_on_segment(corners, j, k)),
      nearest_on_segment(corners, k, i));
  return is_over_face(inside) ? closer_of(nearest_on_thin_face(corners, i, j, k, inside), edge)
                              : edge;
}
// [nearest_on_thin_triangle]

// [nearest_on_triangle]
/// The point of the triangle of corners i, j and k [m] that is closest to the origin; P11, P13.
///
/// Over the face, or beside an edge and not inside of it, or at a corner. A flat triangle is its
/// three edges.
template <class Real>
Nearest<Real> nearest_on_triangle(const Vector3<Real>* corners, int i, int j, int k)
{
  const Vector3<Real>&a = corners[i], &b = corners[j], &c = corners[k];
  const Vector3<Real> ab = b - a, bc = c - b, ca = a - c;
  const Vector3<Real> normal = ca.cross(ab);
  const Real zero(0), squared = normal.squaredNorm();
  const Real ab_squared = ab.squaredNorm(), ca_squared = ca.squaredNorm();
  // How far the origin lies inside each edge, as a fraction of the corner across.
  const Vector3<Real> inside(
      normal.dot(b.cross(bc)), normal.dot(c.cross(ca)), normal.dot(a.cross(ab)));
  if (!(squared > thin_squared_sine<Real> * ab_squared * ca_squared))
  {
    return nearest_on_thin_triangle(corners, i, j, k, inside);
  }
  if (is_over_face(inside))
  {
    const Real size = ab_squared + ca_squared;
    const bool is_narrow = !(squared > narrow_squared_ratio<Real> * size * size);
    Nearest<Real> nearest = is_narrow ? nearest_on_thin_face(corners, i, j, k, inside)
                                      : nearest_on_face(corners, i, j, k, inside);
    // Once more, for a short way: rounding has left some of it along the face.
    nearest.point = normal.dot(nearest.point) / squared * normal;
    return nearest;
  }
  if (!(inside.z() > zero) && a.dot(ab) < zero && b.dot(ab) > zero)
  {
    return nearest_on_line(corners, i, j);
  }
  if (!(inside.x() > zero) && b.dot(bc) < zero && c.dot(bc) > zero)
  {
    return nearest_on_line(corners, j, k);
  }
  if (!(inside.y() > zero) && c.dot(ca) < zero && a.dot(ca) > zero)
  {
    return nearest_on_line(corners, k, i);
  }
  return closer_of(
      closer_of(nearest_on_corner(corners, i), nearest_on_corner(corners, j)),
      nearest_on_corner(corners, k));
}
// [nearest_on_triangle]

} // namespace cookbook
