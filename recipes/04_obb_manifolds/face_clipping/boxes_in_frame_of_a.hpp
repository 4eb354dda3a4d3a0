#pragma once

/// \file
/// \brief Two boxes that overlap, as one of them sees both.

#include "04_obb_manifolds/face_clipping/box_features.hpp"
#include "04_obb_manifolds/separating_axes/separating_axes.hpp"

#include <algorithm>

namespace cookbook
{

// [boxes_in_frame_of_a]
/// Both boxes with A's centre as origin and A's axes as axes, and how they overlap there.
template <class Real>
struct BoxesInFrameOfA
{
  NumberedBox<Real> a;      ///< its edges are 0 … 11
  NumberedBox<Real> b;      ///< its edges are 12 … 23
  LeastOverlap<Real> least; ///< the normal along A's axes
  Real tolerance;           ///< [m], lengths that differ by less may be equal
  Real widest_separation;   ///< [m], the largest gap that a contact point may have
};

/// The largest gap of a contact point, as a part [1] of the smaller box's half extents together.
inline constexpr double contact_separation = 0.01;

/// A and B as A sees them.
template <class Real>
BoxesInFrameOfA<Real>
boxes_in_frame_of_a(const Obb<Real>& a, const Obb<Real>& b, const LeastOverlap<Real>& least)
{
  const RelativeBoxes<Real> boxes = relative_boxes(a, b);
  const Real tolerance = rounding_tolerance(boxes);
  const Real smaller = std::min(boxes.half_a.sum(), boxes.half_b.sum());
  const Matrix3<Real> along_itself = Matrix3<Real>::Identity();
  return {
      {{Vector3<Real>::Zero(), along_itself, boxes.half_a}, 0},
      {{boxes.offset, boxes.rotation, boxes.half_b}, box_edges},
      {a.axes.transpose() * least.normal, least.depth, least.axis},
      tolerance,
      std::min(Real(contact_separation) * smaller, least.depth) + tolerance};
}
// [boxes_in_frame_of_a]

} // namespace cookbook
