#pragma once

/// \file
/// \brief The separating-axis test of two boxes: whether they overlap, which way, and how deep.

#include "04_obb_manifolds/box_axes.hpp"
#include "common/math/norm.hpp"

#include <optional>

namespace cookbook
{

// [rounding_slack]
/// Lengths [m] that differ by less than this may be equal but for rounding; O8.
template <class Real>
Real rounding_slack(const RelativeBoxes<Real>& boxes)
{
  return Real(32) * std::numeric_limits<Real>::epsilon() *
         (boxes.half_a.sum() + boxes.half_b.sum());
}
// [rounding_slack]

// [separating_axes]
/// The direction along which two boxes overlap least.
template <class Real>
struct LeastOverlap
{
  Vector3<Real> normal; ///< [1], unit, world, from A to B
  Real depth;           ///< [m], zero or more
  int axis;             ///< 0 … 14
};

/// The least overlap along the first `axes` of the fifteen; nothing where one of them separates.
template <class Real>
std::optional<LeastOverlap<Real>> least_overlap(const Obb<Real>& a, const Obb<Real>& b, int axes)
{
  using std::sqrt;
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real tie = rounding_slack(boxes);
  LeastOverlap<Real> least{Vector3<Real>::Zero(), std::numeric_limits<Real>::max(), -1};
  for (int axis = 0; axis < axes; ++axis)
  {
    const AxisOverlap<Real> candidate = axis_overlap(boxes, axis);
    if (from_parallel_edges(candidate))
    {
      continue;
    }
    if (!(candidate.overlap >= Real(0)))
    {
      return std::nullopt;
    }
    const Real depth = candidate.overlap / sqrt(candidate.squared_length);
    if (depth < least.depth - tie)
    {
      const Real sign = candidate.offset < Real(0) ? Real(-1) : Real(1);
      least = {sign * candidate.axis, depth, axis};
    }
  }
  least.normal = normalize<Real>(a.axes * least.normal).unit;
  return least;
}

/// Whether two boxes overlap, the way they part soonest, and how deep they are; O1, O5, O7.
///
/// Nothing where they are apart; touching is an overlap of depth 0. Overlaps that differ by less
/// than rounding_slack() are ties: the first axis of A's faces, B's faces, edges wins. Centres that
/// are level along the normal: it points along the axis itself, +a_0 for coincident equal boxes.
/// Distances and sums of half extents must be finite.
template <class Real>
std::optional<LeastOverlap<Real>> separating_axes(const Obb<Real>& a, const Obb<Real>& b)
{
  return least_overlap(a, b, box_axes);
}
// [separating_axes]

} // namespace cookbook
