#pragma once

/// \file
/// \brief The shapes in the plane as plain data; a point is a `Vector<Real, 2>`.

#include "common/math/vector.hpp"

namespace cookbook
{

// [plane_shapes]
/// All points between `start` and `end`, in the plane.
template <class Real>
struct Segment2
{
  Vector<Real, 2> start; ///< [m]
  Vector<Real, 2> end;   ///< [m]; the start again makes a point
};

/// All points origin + t direction with t ≥ 0, in the plane.
template <class Real>
struct Ray2
{
  Vector<Real, 2> origin;    ///< [m]
  Vector<Real, 2> direction; ///< [m], of any length but zero
};

/// All points within `radius` of `center`, in the plane.
template <class Real>
struct Circle
{
  Vector<Real, 2> center; ///< [m]
  Real radius;            ///< [m], zero or more
};

/// All points whose coordinates are within `half_extents` of the center's.
template <class Real>
struct Rectangle
{
  Vector<Real, 2> center;       ///< [m]
  Vector<Real, 2> half_extents; ///< [m], zero or more: it may be flat
};

/// A rectangle turned about its center.
template <class Real>
struct OrientedRectangle
{
  Vector<Real, 2> center;       ///< [m]
  Real angle;                   ///< [rad], counter-clockwise
  Vector<Real, 2> half_extents; ///< [m], along its own axes, zero or more
};
// [plane_shapes]

} // namespace cookbook
