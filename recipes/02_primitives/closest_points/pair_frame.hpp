#pragma once

/// \file
/// \brief Where a pair of shapes is computed, so that no number is too large or too small.

#include "02_primitives/shapes/more_shapes.hpp"
#include "common/math/wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cookbook
{

/// What a shape is made of: first a point of it, then its other points and lengths.
template <class Real>
std::array<Vector3<Real>, 1> numbers_of(const Vector3<Real>& point)
{
  return {point};
}

/// The two ends.
template <class Real>
std::array<Vector3<Real>, 2> numbers_of(const Segment<Real>& segment)
{
  return {segment.start, segment.end};
}

/// Centre and radius.
template <class Real>
std::array<Vector3<Real>, 2> numbers_of(const Sphere<Real>& sphere)
{
  return {sphere.center, Vector3<Real>::Constant(sphere.radius)};
}

/// The two ends and the radius.
template <class Real>
std::array<Vector3<Real>, 3> numbers_of(const Capsule<Real>& capsule)
{
  return {capsule.segment.start, capsule.segment.end, Vector3<Real>::Constant(capsule.radius)};
}

/// The least and the greatest corner.
template <class Real>
std::array<Vector3<Real>, 2> numbers_of(const Aabb<Real>& box)
{
  return {box.min(), box.max()};
}

/// Centre and half extents.
template <class Real>
std::array<Vector3<Real>, 2> numbers_of(const Obb<Real>& box)
{
  return {box.center, box.half_extents};
}

/// Three corners.
template <class Real>
std::array<Vector3<Real>, 3> numbers_of(const Triangle<Real>& triangle)
{
  return {triangle.a, triangle.b, triangle.c};
}

/// Four corners.
template <class Real>
std::array<Vector3<Real>, 4> numbers_of(const Tetrahedron<Real>& solid)
{
  return {solid.a, solid.b, solid.c, solid.d};
}

/// Near a point of the pair and, where squares of squares would leave the range of the number
/// type, enlarged or made smaller by a power of two, which changes no digit.
template <class Real>
struct PairFrame
{
  Vector3<Real> origin; ///< [m], scaled
  Real scale;           ///< [1], a power of two

  /// A point of the world in the frame.
  template <class Number>
  Vector3<Real> in(const Vector3<Number>& point) const
  {
    return point.template cast<Real>() * scale - origin;
  }

  /// A point of the frame in the world.
  Vector3<Real> out(const Vector3<Real>& point) const { return (point + origin) / scale; }
};

/// The power of two that brings numbers up to `size` to ordinary size; 1 where they are.
template <class Real>
Real ordinary_scale(Real size)
{
  constexpr int most = 160; // squares of squares of 2^160 and 2^-160 fit
  const int exponent = size > Real(0) && std::isfinite(size) ? std::ilogb(size) : 0;
  return std::abs(exponent) < most ? Real(1)
                                   : std::ldexp(Real(1), std::clamp(-exponent, -1000, 1000));
}

/// The frame of two shapes.
template <class Real, class First, class Second>
PairFrame<Wide<Real>> pair_frame(const First& a, const Second& b)
{
  using W = Wide<Real>;
  Real size = Real(0);
  for (const Vector3<Real>& v : numbers_of(a))
  {
    size = std::max(size, v.cwiseAbs().maxCoeff());
  }
  for (const Vector3<Real>& v : numbers_of(b))
  {
    size = std::max(size, v.cwiseAbs().maxCoeff());
  }
  const W scale = ordinary_scale<W>(W(size));
  return {widen(numbers_of(a)[0]) * scale, scale};
}

} // namespace cookbook
