#pragma once

/// \file
/// \brief The contact of two boxes on an axis that is already chosen: faces or edges.

#include "04_obb_manifolds/box_box/box_overlaps.hpp"
#include "04_obb_manifolds/box_box/facing_rectangles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

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
template <class Row>
struct EdgeContact
{
  Row normal;   ///< [1], unit, world, from A to B
  Row position; ///< [m], world, midway between the edges' closest points
};

/// The contact of A's edge along its axis i and B's along its axis j; O13.
///
/// All in A's frame, its axes taken in the order i, i+1, i+2: there L = a_i × b_j is (0, −b₂, b₁).
/// The point of B's edge is where the lines cross, the point of A's edge is the closest to that.
template <class Row, class Real, class Which>
EdgeContact<Row>
edge_contact(const Obb<Real>& a, const BoxesInRows<Row>& boxes, const Which& i, const Which& j)
{
  using std::copysign, std::sqrt;
  const Which i1 = next(i), i2 = next(i1), j1 = next(j), j2 = next(j1);
  const Row& row0 = chosen(boxes.rows, i);
  const Row& row1 = chosen(boxes.rows, i1);
  const Row& row2 = chosen(boxes.rows, i2);
  const auto b = [&](const Which& k) -> Vector3<Real> {
    return {chosen(row0, k), chosen(row1, k), chosen(row2, k)};
  };
  const Vector3<Real> t(
      chosen(boxes.offset_a, i), chosen(boxes.offset_a, i1), chosen(boxes.offset_a, i2));

  const Vector3<Real> bj = b(j), bj1 = b(j1), bj2 = b(j2);
  const Real l1 = -bj[2], l2 = bj[1];
  const Real side = copysign(Real(1), t[1] * l1 + t[2] * l2);
  const Real squared = l1 * l1 + l2 * l2, per_squared = Real(1) / squared;

  const Real a1 = copysign(chosen(boxes.half_a, i1), side * l1);
  const Real a2 = copysign(chosen(boxes.half_a, i2), side * l2);
  const Real b1 = copysign(chosen(boxes.half_b, j1), side * (l1 * bj1[1] + l2 * bj1[2]));
  const Real b2 = copysign(chosen(boxes.half_b, j2), side * (l1 * bj2[1] + l2 * bj2[2]));
  const Vector3<Real> middle_b = t - bj1 * b1 - bj2 * b2;

  const Real beside = (middle_b[1] - a1) * bj[1] + (middle_b[2] - a2) * bj[2];
  const Real along_b = clamped(-beside * per_squared, chosen(boxes.half_b, j));
  const Vector3<Real> on_b = middle_b + bj * along_b;
  const Real along_a = clamped(on_b[0], chosen(boxes.half_a, i));

  Row axes[3];
  get_axes(a, axes);
  const Row &e0 = chosen(axes, i), &e1 = chosen(axes, i1), &e2 = chosen(axes, i2);
  const Real half(0.5f);
  const Row middle = e0 * Row((along_a + on_b[0]) * half) + e1 * Row((a1 + on_b[1]) * half) +
                     e2 * Row((a2 + on_b[2]) * half);
  const Real unit = side / sqrt(squared);
  return {e1 * Row(l1 * unit) + e2 * Row(l2 * unit), row_of<Row>(a.center) + middle};
}
// [edge_contact]

// [face_contact]
/// Where two faces meet: up to eight points, as two times four.
template <class Row>
struct FaceContact
{
  using Real = typename Row::Number;
  using Four = typename Row::Four;

  Vector3<Real> normal;        ///< [1], unit, world, from A to B
  Four position[2][3];         ///< [m], world: x, y and z of twice four points
  Four depth[2];               ///< [m]
  typename Four::Mask kept[2]; ///< which of the points there are
  Index<Real> incident;        ///< the other box's axis
};

/// The contact of a box's face along its axis k with the face of the other that looks at it most
/// directly; O10, O12, O14.
///
/// `c` are the rows of the other box's axes as this one sees them, `offset` is where its centre is.
/// Points with a gap are kept up to `separation` [m]; lengths within `tolerance` [m] are equal.
/// There is no point where the faces touch and share no more than `tolerance` at their rims.
/// Mirrored boxes are as good as others.
template <class Row, class Real, class Which>
FaceContact<Row> face_contact(
    const Obb<Real>& box, const Obb<Real>& other, const Row (&c)[3], const Row& offset,
    const Which& k, const Real& separation, const Real& tolerance)
{
  using Four = typename Row::Four;
  using std::copysign, std::max;
  const Which u = next(k), v = next(u);
  const Row& row_k = chosen(c, k);
  const Row& row_u = chosen(c, u);
  const Row& row_v = chosen(c, v);
  const Real offset_k = chosen(offset, k);
  const Real side = copysign(Real(1), offset_k);

  const Row slant = abs(row_k);
  const Real most = max(slant[0], max(slant[1], slant[2]));
  const Index<Real> incident = first_set({Row(most) <= slant});
  const auto m = which(incident);
  const auto p = next(m), q = next(p);
  const auto half = [](const Obb<Real>& of, const auto& axis)
  { return chosen(of.half_extents, axis); };
  const Real half_p = half(other, p), half_q = half(other, q);
  const Real way_m = -copysign(half(other, m), side * chosen(row_k, m));
  const Real half_k = half(box, k);
  const Real turn = chosen(row_u, p) * chosen(row_v, q) - chosen(row_v, p) * chosen(row_u, q);
  const Real left = copysign(half_q, turn);
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

  // Where boxes only touch, along edges, the clipping does not find their common corners.
  Real widest = separation;
  const auto touch = separation <= tolerance;
  if (any(touch)) [[unlikely]]
  {
    const Real none(-std::numeric_limits<float>::max()), wide = facing_overlap(rectangles);
    widest = select(touch & (wide <= tolerance), none, separation);
  }
  FaceContact<Row> contact;
  contact.incident = incident;
  contact.normal = axis_of(box, k) * side;
  const Vector3<Real> axis_u = axis_of(box, u), axis_v = axis_of(box, v);
  const FourCorners<Four> corners[] = {
      corners_on_other<Four>(rectangles, tolerance), corners_on_this<Four>(rectangles, tolerance)};
  for (int part = 0; part < 2; ++part)
  {
    const FourCorners<Four>& four = corners[part];
    const Four up = Four(half_k) - four.depth * Four(Real(0.5f));
    for (int x = 0; x < 3; ++x)
    {
      contact.position[part][x] =
          Four(box.center[x]) +
          (Four(axis_u[x]) * four.u + Four(axis_v[x]) * four.v + Four(contact.normal[x]) * up);
    }
    contact.depth[part] = four.depth;
    contact.kept[part] = four.there & (Four(-widest) <= four.depth);
  }
  return contact;
}
// [face_contact]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
