#pragma once

/// \file
/// \brief The contact of two boxes on an axis that is already chosen: faces or edges.

#include "04_obb_manifolds/box_overlaps.hpp"
#include "04_obb_manifolds/face_overlap_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

/// A number, or its opposite where another is negative.
template <class Real>
Real with_sign(const Real& number, const Real& sign)
{
  using std::copysign;
  return number * copysign(Real(1), sign);
}

/// A number brought between −most and most.
template <class Real>
Real clamped(const Real& x, const Real& most)
{
  using std::max, std::min;
  return max(min(x, most), -most);
}

/// Column k of a box's axes, where k differs from pair to pair.
template <class Real, class K>
Vector3<Real> axis_of(const Obb<Real>& box, const K& k)
{
  if constexpr (std::is_same_v<K, int>)
  {
    return box.axes.col(k);
  }
  else
  {
    const auto row = [&](int i)
    { return select(k.is[0], box.axes(i, 0), select(k.is[1], box.axes(i, 1), box.axes(i, 2))); };
    return {row(0), row(1), row(2)};
  }
}

// [edge_contact]
/// Where two edges cross.
template <class Real>
struct EdgeContact
{
  Vector3<Real> normal;   ///< [1], unit, world, from A to B
  Vector3<Real> position; ///< [m], world, midway between the edges' closest points
};

/// The contact of A's edge along its axis i and B's along its axis j; O13.
///
/// All in A's frame, its axes taken in the order i, i+1, i+2: there L = a_i × b_j is (0, −b₂, b₁).
template <class Real, class Lane>
EdgeContact<Real>
edge_contact(const Obb<Real>& a, const BoxesInRows<Real>& boxes, const Lane& i, const Lane& j)
{
  using Row = Group<Real, 3>;
  using std::sqrt;
  const Lane i1 = next(i), i2 = next(i1), j1 = next(j), j2 = next(j1);
  const Row& row0 = chosen(boxes.rows, i);
  const Row& row1 = chosen(boxes.rows, i1);
  const Row& row2 = chosen(boxes.rows, i2);
  const auto b = [&](const Lane& k) -> Vector3<Real> {
    return {chosen(row0, k), chosen(row1, k), chosen(row2, k)};
  };
  const Vector3<Real> t(
      chosen(boxes.offset_a, i), chosen(boxes.offset_a, i1), chosen(boxes.offset_a, i2));

  const Vector3<Real> bj = b(j), bj1 = b(j1), bj2 = b(j2);
  const Real squared = bj[1] * bj[1] + bj[2] * bj[2];
  const Real scale = with_sign(Real(1) / sqrt(squared), t[2] * bj[1] - t[1] * bj[2]);
  const Real n1 = -bj[2] * scale, n2 = bj[1] * scale;

  const Real a1 = with_sign(chosen(boxes.half_a, i1), n1);
  const Real a2 = with_sign(chosen(boxes.half_a, i2), n2);
  const Real b1 = with_sign(chosen(boxes.half_b, j1), n1 * bj1[1] + n2 * bj1[2]);
  const Real b2 = with_sign(chosen(boxes.half_b, j2), n1 * bj2[1] + n2 * bj2[2]);
  const Vector3<Real> middle_b = t - bj1 * b1 - bj2 * b2;
  const Vector3<Real> d(middle_b[0], middle_b[1] - a1, middle_b[2] - a2);

  const Real half_a = chosen(boxes.half_a, i), half_b = chosen(boxes.half_b, j);
  const Real crossing = d[0] - bj[0] * (d[1] * bj[1] + d[2] * bj[2]) / squared;
  const Real along_b = clamped(
      clamped(crossing, half_a) * bj[0] - (d[0] * bj[0] + d[1] * bj[1] + d[2] * bj[2]), half_b);
  const Vector3<Real> on_b = middle_b + bj * along_b;
  const Real along_a = clamped(on_b[0], half_a);

  const Vector3<Real> e0 = axis_of(a, i), e1 = axis_of(a, i1), e2 = axis_of(a, i2);
  const Real half(0.5f);
  return {
      e1 * n1 + e2 * n2, a.center + (e0 * ((along_a + on_b[0]) * half) +
                                     e1 * ((a1 + on_b[1]) * half) + e2 * ((a2 + on_b[2]) * half))};
}
// [edge_contact]

// [face_contact]
/// Where two faces meet: up to eight points, as two times four.
template <class Real>
struct FaceContact
{
  Vector3<Real> normal;                  ///< [1], unit, world, from A to B
  Group<Real, 4> position[2][3];         ///< [m], world: x, y and z of twice four points
  Group<Real, 4> depth[2];               ///< [m]
  typename Group<Real, 4>::Mask kept[2]; ///< which of the points there are
  Index<Real> incident;                  ///< the other box's axis
};

/// The contact of a box's face along its axis k with the face of the other that looks at it most
/// directly; O10, O12, O14.
///
/// `c` are the rows of the other box's axes as this one sees them, `offset` is where its centre is.
/// Points with a gap are kept up to `gap` [m]; a hair [m] decides no corner.
template <class Real, class Lane>
FaceContact<Real> face_contact(
    const Obb<Real>& box, const Obb<Real>& other, const Group<Real, 3> (&c)[3],
    const Group<Real, 3>& offset, const Lane& k, const Real& gap, const Real& hair)
{
  using Row = Group<Real, 3>;
  using Four = Group<Real, 4>;
  using std::abs;
  const Lane u = next(k), v = next(u);
  const Row& row_k = chosen(c, k);
  const Row& row_u = chosen(c, u);
  const Row& row_v = chosen(c, v);
  const Real offset_k = chosen(offset, k);
  const Real side = with_sign(Real(1), offset_k);

  const Row slant = abs(row_k);
  const auto second = slant[0] < slant[1];
  const Real more = select(second, slant[1], slant[0]);
  const Index<Real> incident =
      select(more < slant[2], index<Real>(2), select(second, index<Real>(1), index<Real>(0)));
  const auto m = which(incident);
  const auto p = next(m), q = next(p);
  const auto half = [](const Obb<Real>& of, const auto& axis)
  { return chosen(of.half_extents, axis); };
  const Real half_p = half(other, p), half_q = half(other, q);
  const Real way_m = with_sign(-half(other, m), side * chosen(row_k, m));
  const Real half_k = half(box, k);
  const Real left = with_sign(half_q, chosen(row_k, m));
  const FacingRectangles<Real> rectangles{
      half(box, u),
      half(box, v),
      chosen(offset, u) + way_m * chosen(row_u, m),
      chosen(offset, v) + way_m * chosen(row_v, m),
      half_p * chosen(row_u, p),
      half_p * chosen(row_v, p),
      left * chosen(row_u, q),
      left * chosen(row_v, q),
      half_p,
      half_q,
      half_k - side * (offset_k + way_m * chosen(row_k, m)),
      -side * half_p * chosen(row_k, p),
      -side * left * chosen(row_k, q)};

  FaceContact<Real> contact;
  contact.incident = incident;
  contact.normal = axis_of(box, k) * side;
  const Vector3<Real> axis_u = axis_of(box, u), axis_v = axis_of(box, v);
  const FourCorners<Real> corners[] = {
      corners_on_other<Real>(rectangles, hair), corners_on_this<Real>(rectangles, hair)};
  for (int part = 0; part < 2; ++part)
  {
    const FourCorners<Real>& four = corners[part];
    const Four up = Four(half_k) - four.depth * Four(Real(0.5f));
    for (int x = 0; x < 3; ++x)
    {
      contact.position[part][x] =
          Four(box.center[x]) + (Four(axis_u[x]) * four.u + Four(axis_v[x]) * four.v +
                                 Four(contact.normal[x]) * up);
    }
    contact.depth[part] = four.depth;
    contact.kept[part] = four.there & (Four(-gap) <= four.depth);
  }
  return contact;
}
// [face_contact]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
