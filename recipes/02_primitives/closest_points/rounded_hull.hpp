#pragma once

/// \file
/// \brief Every bounded shape of the book as a few corners and a radius.

#include "02_primitives/closest_points/pair_frame.hpp"

#include <array>
#include <cstddef>

namespace cookbook
{

/// All points within `radius` of the convex hull of the corners.
template <class Real, int Size>
struct RoundedHull
{
  std::array<Vector3<Real>, std::size_t(Size)> corners; ///< [m]
  Real radius = Real(0);                                ///< [m], zero or more
};

/// A point is its one corner.
template <class Real>
RoundedHull<Wide<Real>, 1> rounded_hull(const Vector3<Real>& p, const PairFrame<Wide<Real>>& frame)
{
  return {{frame.in(p)}};
}

/// A sphere is its centre and its radius.
template <class Real>
RoundedHull<Wide<Real>, 1>
rounded_hull(const Sphere<Real>& sphere, const PairFrame<Wide<Real>>& frame)
{
  return {{frame.in(sphere.center)}, Wide<Real>(sphere.radius) * frame.scale};
}

/// A segment has two corners.
template <class Real>
RoundedHull<Wide<Real>, 2>
rounded_hull(const Segment<Real>& segment, const PairFrame<Wide<Real>>& frame)
{
  return {{frame.in(segment.start), frame.in(segment.end)}};
}

/// A capsule is its segment and its radius.
template <class Real>
RoundedHull<Wide<Real>, 2>
rounded_hull(const Capsule<Real>& capsule, const PairFrame<Wide<Real>>& frame)
{
  const Segment<Real>& segment = capsule.segment;
  return {
      {frame.in(segment.start), frame.in(segment.end)}, Wide<Real>(capsule.radius) * frame.scale};
}

/// A triangle has three corners.
template <class Real>
RoundedHull<Wide<Real>, 3>
rounded_hull(const Triangle<Real>& triangle, const PairFrame<Wide<Real>>& frame)
{
  return {{frame.in(triangle.a), frame.in(triangle.b), frame.in(triangle.c)}};
}

/// A tetrahedron has four corners.
template <class Real>
RoundedHull<Wide<Real>, 4>
rounded_hull(const Tetrahedron<Real>& solid, const PairFrame<Wide<Real>>& frame)
{
  return {{frame.in(solid.a), frame.in(solid.b), frame.in(solid.c), frame.in(solid.d)}};
}

/// A box along the world's axes has eight corners.
template <class Real>
RoundedHull<Wide<Real>, 8> rounded_hull(const Aabb<Real>& box, const PairFrame<Wide<Real>>& frame)
{
  const Vector3<Wide<Real>> least = frame.in(box.min()), most = frame.in(box.max());
  RoundedHull<Wide<Real>, 8> hull;
  for (unsigned i = 0; i < 8; ++i)
  {
    hull.corners[i] = {
        (i & 1u ? most : least).x(), (i & 2u ? most : least).y(), (i & 4u ? most : least).z()};
  }
  return hull;
}

/// An oriented box, too.
template <class Real>
RoundedHull<Wide<Real>, 8> rounded_hull(const Obb<Real>& box, const PairFrame<Wide<Real>>& frame)
{
  const Vector3<Wide<Real>> center = frame.in(box.center);
  const Matrix3<Wide<Real>> half =
      widen(box.axes) * (frame.scale * widen(box.half_extents)).asDiagonal();
  RoundedHull<Wide<Real>, 8> hull;
  for (unsigned i = 0; i < 8; ++i)
  {
    const auto side = [i](unsigned bit) { return Wide<Real>(i & bit ? 1 : -1); };
    hull.corners[i] =
        center + (side(1) * half.col(0) + side(2) * half.col(1)) + side(4) * half.col(2);
  }
  return hull;
}

} // namespace cookbook
