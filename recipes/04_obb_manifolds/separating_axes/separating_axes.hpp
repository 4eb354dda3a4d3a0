#pragma once

/// \file
/// \brief The separating-axis test of two boxes: whether they overlap, which way, and how deep.

#include "02_primitives/boxes_overlap/box_axes.hpp"
#include "common/math/norm.hpp"

#include <optional>

namespace cookbook
{

// [rounding_tolerance]
/// Lengths [m] of two boxes that differ by less than this may be equal but for rounding; O8.
template <class Real>
Real rounding_tolerance(const RelativeBoxes<Real>& boxes)
{
  return Real(32) * std::numeric_limits<Real>::epsilon() *
         (boxes.half_a.sum() + boxes.half_b.sum());
}
// [rounding_tolerance]

// [overlap_rounding]
/// Two boxes seen from A as if no product in a sum were negative: what rounding grows with.
template <class Real>
struct RoundedTerms
{
  Matrix3<Real> rotation; ///< G = |A|ᵀ|B| [1], for C = AᵀB
  Vector3<Real> lengths;  ///< |A|ᵀ|c_B − c_A| + h_A + G h_B [m], along each of A's axes
};

/// The sizes of all terms that are added up for the overlaps of two boxes.
template <class Real>
RoundedTerms<Real> rounded_terms(const Obb<Real>& a, const Obb<Real>& b)
{
  const Matrix3<Real> sizes_a = a.axes.cwiseAbs().transpose();
  const Matrix3<Real> rotation = sizes_a * b.axes.cwiseAbs();
  const Vector3<Real> offset = sizes_a * (b.center - a.center).cwiseAbs();
  return {rotation, offset + a.half_extents + rotation * b.half_extents};
}

/// How far rounding may move the overlap along an axis [m]; O8 with the axis' own terms.
template <class Real>
Real overlap_rounding(const RoundedTerms<Real>& terms, const AxisOverlap<Real>& along, int axis)
{
  using std::sqrt;
  const Real separations = Real(8) * std::numeric_limits<Real>::epsilon();
  switch (axis_kind(axis))
  {
  case AxisKind::face_of_a:
    return separations * terms.lengths[axis];
  case AxisKind::face_of_b:
    return separations * terms.rotation.col(axis - 3).dot(terms.lengths);
  default:
    return separations * along.axis.cwiseAbs().dot(terms.lengths) / sqrt(along.squared_length);
  }
}
// [overlap_rounding]

// [least_overlap]
/// The direction along which two boxes overlap least.
template <class Real>
struct LeastOverlap
{
  Vector3<Real> normal; ///< [1], unit, world, from A to B
  Real depth;           ///< [m], zero or more
  int axis;             ///< 0 … 14
};
// [least_overlap]

// [is_beyond_rounding]
/// Whether the overlap along one axis is less than along another by more than rounding, where the
/// gain [m] does not tell by itself; O9. Rarely called, and kept out of the loop that calls it.
template <class Real>
[[gnu::noinline]] bool is_beyond_rounding(
    Real gain, const Obb<Real>& a, const Obb<Real>& b, const RelativeBoxes<Real>& boxes, int axis,
    int other)
{
  const RoundedTerms<Real> terms = rounded_terms(a, b);
  const auto rounding = [&](int each)
  { return overlap_rounding(terms, axis_overlap(boxes, each), each); };
  return gain > rounding(axis) + rounding(other);
}
// [is_beyond_rounding]

// [separating_axes]
/// The least overlap along the first `axes` of the fifteen; nothing where one of them separates.
template <class Real>
std::optional<LeastOverlap<Real>> least_overlap(const Obb<Real>& a, const Obb<Real>& b, int axes)
{
  using std::sqrt;
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real tolerance = rounding_tolerance(boxes);
  LeastOverlap<Real> least{Vector3<Real>::Zero(), std::numeric_limits<Real>::max(), -1};
  for (int axis = 0; axis < axes; ++axis)
  {
    const AxisOverlap<Real> along = axis_overlap(boxes, axis);
    if (from_parallel_edges(along))
    {
      continue;
    }
    if (!(along.overlap >= Real(0)))
    {
      return std::nullopt;
    }
    const Real depth = along.overlap / sqrt(along.squared_length), gain = least.depth - depth;
    if (gain > tolerance ||
        (gain > Real(0) && is_beyond_rounding(gain, a, b, boxes, axis, least.axis)))
    {
      const Real sign = along.offset < Real(0) ? Real(-1) : Real(1);
      least = {sign * along.axis, depth, axis};
    }
  }
  least.normal = normalize<Real>(a.axes * least.normal).unit;
  return least;
}

/// Whether two boxes overlap, the way of their minimum translation vector, and how deep they are;
/// O1, O5, O7.
///
/// Nothing where they are apart; touching is an overlap of depth 0. Overlaps that differ by less
/// than their overlap_rounding() together are ties: the first axis of A's faces, B's faces, edges
/// wins, and the depth may be that much above the least. Centres that are level along the normal:
/// it points along the axis itself, +a_0 for coincident equal boxes. Distances and sums of half
/// extents must be finite.
template <class Real>
std::optional<LeastOverlap<Real>> separating_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_overlap(a, b, box_axes);
}
// [separating_axes]

} // namespace cookbook
