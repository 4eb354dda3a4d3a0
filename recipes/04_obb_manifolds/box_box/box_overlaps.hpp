#pragma once

/// \file
/// \brief The overlaps of two boxes along all fifteen axes, three axes at a time.

#include "02_primitives/shapes/shapes.hpp"
#include "common/simd/row.hpp"

#include <algorithm>

namespace cookbook
{
inline namespace COOKBOOK_INSTRUCTION_SET
{

// [boxes_in_rows]
/// Two boxes seen from A, its numbers in rows of three.
template <class Row>
struct BoxesInRows
{
  Row rows[3];    ///< C [1], row i is A's axis i against B's three
  Row columns[3]; ///< Cᵀ [1], row j is B's axis j against A's three
  Row half_a;     ///< [m], A's half extents
  Row half_b;     ///< [m], B's
  Row offset_a;   ///< t [m], from A's centre to B's along A's axes
  Row offset_b;   ///< −Cᵀt [m], from B's centre to A's along B's axes
};

/// The axes of a box as rows, each its x, y and z.
template <class Row, class Real>
void get_axes(const Obb<Real>& box, Row (&axes)[3])
{
  for (int i = 0; i < 3; ++i)
  {
    axes[i] = row_of<Row>(box.axes.col(i));
  }
}

/// The sum of three rows, each times a number.
template <class Row, class Real>
Row combined(const Row (&rows)[3], const Real& x, const Real& y, const Real& z)
{
  return rows[0] * Row(x) + rows[1] * Row(y) + rows[2] * Row(z);
}

/// B as A sees it, its centre at d [m] from A's.
template <class Row, class Real>
BoxesInRows<Row> boxes_in_rows(const Obb<Real>& a, const Obb<Real>& b, const Vector3<Real>& d)
{
  Row axes_a[3], axes_b[3];
  get_axes(a, axes_a);
  get_axes(b, axes_b);
  transpose(axes_a);
  transpose(axes_b);
  BoxesInRows<Row> boxes;
  for (int i = 0; i < 3; ++i)
  {
    boxes.rows[i] = combined(axes_b, a.axes(0, i), a.axes(1, i), a.axes(2, i));
  }
  std::copy(boxes.rows, boxes.rows + 3, boxes.columns);
  transpose(boxes.columns);
  boxes.half_a = row_of<Row>(a.half_extents);
  boxes.half_b = row_of<Row>(b.half_extents);
  boxes.offset_a = combined(axes_a, d[0], d[1], d[2]);
  boxes.offset_b = combined(axes_b, -d[0], -d[1], -d[2]);
  return boxes;
}

/// B as A sees it.
template <class Row, class Real>
BoxesInRows<Row> boxes_in_rows(const Obb<Real>& a, const Obb<Real>& b)
{
  return boxes_in_rows<Row, Real>(a, b, b.center - a.center);
}
// [boxes_in_rows]

// [face_overlaps]
/// The overlaps [m] along the three axes of a box: its half extents, the projected radius of the
/// other box along each, less the distance of the centres; O2.
template <class Row>
Row face_overlaps(const Row& half, const Row (&others)[3], const Row& half_other, const Row& offset)
{
  const Row radius[] = {abs(others[0]), abs(others[1]), abs(others[2])};
  return half + combined(radius, half_other[0], half_other[1], half_other[2]) - abs(offset);
}
// [face_overlaps]

// [edge_overlaps]
/// The overlaps along a_i × b_0, a_i × b_1 and a_i × b_2, as long as these are.
template <class Row>
struct EdgeOverlaps
{
  Row overlap; ///< |L| times metres; O3
  Row squared; ///< |L|², O4
};

/// The overlaps along A's edge i crossed with all three of B's.
///
/// In place of |C| stand the cofactors of C, from the very L that is used everywhere else: equal in
/// exact numbers, and right also where the edges are nearly parallel.
template <class Row>
EdgeOverlaps<Row> edge_overlaps(const BoxesInRows<Row>& boxes, int i)
{
  const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
  const Row &r1 = boxes.rows[i1], &r2 = boxes.rows[i2];
  const Row cofactor = abs(turned_once(r1) * r2 - turned_once(r2) * r1);
  const Row radius_a = abs(r2) * Row(boxes.half_a[i1]) + abs(r1) * Row(boxes.half_a[i2]);
  const Row radius_b =
      turned_once(boxes.half_b) * cofactor + turned_twice(boxes.half_b) * turned_twice(cofactor);
  const Row offset = r1 * Row(boxes.offset_a[i2]) - r2 * Row(boxes.offset_a[i1]);
  return {radius_a + radius_b - abs(offset), r1 * r1 + r2 * r2};
}
// [edge_overlaps]

} // namespace COOKBOOK_INSTRUCTION_SET
} // namespace cookbook
