#pragma once

/// \file
/// \brief All differences of a point of A and a point of B, by its support function alone.

#include "02_primitives/boxes_overlap/box_axes.hpp"

namespace cookbook
{

// [support_point]
/// The support point of the Minkowski difference A ⊖ B along a direction, and the point of A that
/// it came from.
template <class Real>
struct SupportPoint
{
  Vector3<Real> point; ///< [m], a − b
  Vector3<Real> on_a;  ///< [m], a
};
// [support_point]

// [minkowski_difference]
/// The corner of the box [−h, h] farthest along a direction; the positive one where it is level.
template <class Real>
Vector3<Real> support_corner(const Vector3<Real>& direction, const Vector3<Real>& half_extents)
{
  const auto side = [](Real x) { return x < Real(0) ? Real(-1) : Real(1); };
  return half_extents.cwiseProduct(direction.unaryExpr(side));
}

/// The solid A ⊖ B of two boxes in A's frame. Called with a direction of any length, it answers
/// with its support point: A's farthest corner less B's in the opposite direction.
template <class Real>
struct MinkowskiDifference
{
  RelativeBoxes<Real> boxes; ///< both boxes

  /// The farthest point along a direction; a zero direction will do.
  SupportPoint<Real> operator()(const Vector3<Real>& direction) const
  {
    const Vector3<Real> in_b = boxes.rotation.transpose() * -direction;
    const Vector3<Real> on_a = support_corner(direction, boxes.half_a);
    const Vector3<Real> on_b = boxes.offset + boxes.rotation * support_corner(in_b, boxes.half_b);
    return {on_a - on_b, on_a};
  }
};
// [minkowski_difference]

// [separates]
/// Whether a direction separates: the solid's farthest point along it does not reach the origin.
///
/// The one place where touching and apart are told from each other. Any direction is fair: where
/// it is a little off, the farthest point is the farthest along what it is.
template <class Real>
bool separates(const Vector3<Real>& found, const Vector3<Real>& direction)
{
  return found.dot(direction) < Real(0);
}
// [separates]

} // namespace cookbook
