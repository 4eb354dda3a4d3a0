#pragma once

/// \file
/// \brief The fifteen axes along which two boxes may be apart, and their overlap along each.

#include "02_primitives/shapes/shapes.hpp"
#include "common/math/wide.hpp"

#include <cmath>
#include <limits>

namespace cookbook
{

// [relative_boxes]
/// Two boxes seen from A: its centre is the origin, its axes are those of the coordinates.
template <class Real>
struct RelativeBoxes
{
  Matrix3<Real> rotation; ///< C [1], column j is B's axis j in A's frame
  Matrix3<Real> absolute; ///< |C| [1], entry by entry
  Vector3<Real> offset;   ///< t [m], from A's centre to B's, in A's frame
  Vector3<Real> half_a;   ///< [m], A's half extents
  Vector3<Real> half_b;   ///< [m], B's half extents
};

/// B in A's frame: C = AᵀB and t = Aᵀ(c_B − c_A), the difference in the wider type.
template <class Real>
RelativeBoxes<Real> relative_boxes(const Obb<Real>& a, const Obb<Real>& b)
{
  const Matrix3<Real> rotation = a.axes.transpose() * b.axes;
  const Vector3<Wide<Real>> offset =
      widen(a.axes).transpose() * (widen(b.center) - widen(a.center));
  return {
      rotation, rotation.cwiseAbs(), offset.template cast<Real>(), a.half_extents, b.half_extents};
}
// [relative_boxes]

// [axis_overlap]
/// How far the projections of two boxes on an axis L overlap; O2, O6.
///
/// L has the length that its formula gives it; divide by it before comparing one axis with another.
template <class Real>
struct AxisOverlap
{
  Vector3<Real> axis; ///< L, in A's frame
  Real offset;        ///< t·L, |L| times metres
  Real overlap; ///< r_A + r_B − |t·L|, |L| times metres; negative where the projections are apart
  Real squared_length; ///< |L|²
};

/// The overlap of A's reach and B's along an axis.
template <class Real>
AxisOverlap<Real>
axis_overlap(const Vector3<Real>& axis, Real offset, Real radii, Real squared_length)
{
  using std::abs;
  return {axis, offset, radii - abs(offset), squared_length};
}
// [axis_overlap]

// [face_axes]
/// Along A's axis i, the normal of two of A's faces.
template <class Real>
AxisOverlap<Real> face_axis_of_a(const RelativeBoxes<Real>& boxes, int i)
{
  const Real radii = boxes.half_a[i] + boxes.absolute.row(i).dot(boxes.half_b);
  return axis_overlap<Real>(Vector3<Real>::Unit(i), boxes.offset[i], radii, Real(1));
}

/// Along B's axis j, the normal of two of B's faces.
template <class Real>
AxisOverlap<Real> face_axis_of_b(const RelativeBoxes<Real>& boxes, int j)
{
  const Vector3<Real> axis = boxes.rotation.col(j);
  const Real radii = boxes.absolute.col(j).dot(boxes.half_a) + boxes.half_b[j];
  return axis_overlap<Real>(axis, boxes.offset.dot(axis), radii, Real(1));
}
// [face_axes]

// [edge_axis]
/// a_i · (b_j × b_k) [1] for every two of B's axes, at the index of the third: how far those two
/// reach along a_i × b_j and a_i × b_k. Of exact axes it is row i of C once more.
template <class Real>
Vector3<Real> triple_products(const RelativeBoxes<Real>& boxes, int i)
{
  const Vector3<Real> one = boxes.rotation.row((i + 1) % 3),
                      other = boxes.rotation.row((i + 2) % 3);
  return one.cross(other);
}

/// Along L = a_i × b_j, perpendicular to an edge of each box; O3, O4. `triple` is
/// triple_products(boxes, i).
///
/// B's reach is measured along L itself, not read off as |C|: near-parallel edges make L as short
/// as rounding is large, and only an L that is the same in all three terms is then still an axis.
template <class Real>
AxisOverlap<Real>
edge_axis(const RelativeBoxes<Real>& boxes, int i, int j, const Vector3<Real>& triple)
{
  using std::abs;
  const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
  const Real l1 = -boxes.rotation(i2, j), l2 = boxes.rotation(i1, j);
  Vector3<Real> axis = Vector3<Real>::Zero();
  axis[i1] = l1;
  axis[i2] = l2;
  const Real radius_a =
      boxes.half_a[i1] * boxes.absolute(i2, j) + boxes.half_a[i2] * boxes.absolute(i1, j);
  const Real radius_b = boxes.half_b[j1] * abs(triple[j2]) + boxes.half_b[j2] * abs(triple[j1]);
  const Real offset = boxes.offset[i1] * l1 + boxes.offset[i2] * l2;
  return axis_overlap<Real>(axis, offset, radius_a + radius_b, l1 * l1 + l2 * l2);
}

/// The same for one axis alone.
template <class Real>
AxisOverlap<Real> edge_axis(const RelativeBoxes<Real>& boxes, int i, int j)
{
  return edge_axis(boxes, i, j, triple_products(boxes, i));
}

/// Whether the axis is the cross product of edges so nearly parallel that it can be left out.
///
/// Its length is the sine of their angle. At a sine of ε, the gap between 1 and the next number,
/// faces say the same to within rounding; exact numbers leave out exact parallels only.
template <class Real>
bool from_parallel_edges(const AxisOverlap<Real>& candidate)
{
  const Real sine = std::numeric_limits<Real>::epsilon();
  return candidate.squared_length <= sine * sine;
}
// [edge_axis]

// [fifteen_axes]
/// The number of axes to test: all pairs of the six edge directions of two boxes; O1.
inline constexpr int box_axes = 15;

/// What an axis is perpendicular to.
enum class AxisKind
{
  face_of_a, ///< axes 0, 1, 2
  face_of_b, ///< axes 3, 4, 5
  edges      ///< axis 6 + 3 i + j is a_i × b_j
};

/// The kind of axis 0 … 14.
inline AxisKind axis_kind(int axis)
{
  return axis < 3 ? AxisKind::face_of_a : axis < 6 ? AxisKind::face_of_b : AxisKind::edges;
}

/// The overlap along axis 0 … 14: faces of A, faces of B, pairs of edges.
template <class Real>
AxisOverlap<Real> axis_overlap(const RelativeBoxes<Real>& boxes, int axis)
{
  switch (axis_kind(axis))
  {
  case AxisKind::face_of_a:
    return face_axis_of_a(boxes, axis);
  case AxisKind::face_of_b:
    return face_axis_of_b(boxes, axis - 3);
  default:
    return edge_axis(boxes, (axis - 6) / 3, (axis - 6) % 3);
  }
}
// [fifteen_axes]

} // namespace cookbook
