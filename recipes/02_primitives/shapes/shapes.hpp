#pragma once

/// \file
/// \brief The shapes of the book as plain data.

#include "common/math/vector.hpp"

namespace cookbook
{

// [shapes]
/// All points within `radius` of `center`.
template <class Real>
struct Sphere
{
  Vector3<Real> center; ///< [m], world
  Real radius;          ///< [m], zero or more
};

/// An oriented bounding box: all points whose coordinates along the axes are within half_extents.
template <class Real>
struct Obb
{
  Vector3<Real> center;       ///< [m], world
  Matrix3<Real> axes;         ///< [1], columns are the box's unit axes in the world
  Vector3<Real> half_extents; ///< [m], along each axis, greater than zero
};

/// All points with normal·x = distance; the solid half-space is where normal·x is less.
template <class Real>
struct Plane
{
  Vector3<Real> normal; ///< [1], unit, world, out of the solid
  Real distance;        ///< [m], of the plane from the origin, along the normal
};

/// All points between `start` and `end`.
template <class Real>
struct Segment
{
  Vector3<Real> start; ///< [m], world
  Vector3<Real> end;   ///< [m], world
};

/// All points within `radius` of a segment.
template <class Real>
struct Capsule
{
  Segment<Real> segment; ///< [m], world
  Real radius;           ///< [m], zero or more
};

/// A flat triangle.
template <class Real>
struct Triangle
{
  Vector3<Real> a; ///< [m], world
  Vector3<Real> b; ///< [m], world
  Vector3<Real> c; ///< [m], world
};

/// All points origin + t direction with t ≥ 0.
template <class Real>
struct Ray
{
  Vector3<Real> origin;    ///< [m], world
  Vector3<Real> direction; ///< [m], world, of any length but zero
};
// [shapes]

} // namespace cookbook
