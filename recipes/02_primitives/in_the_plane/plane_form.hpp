#pragma once

/// \file
/// \brief Every shape in the plane in one form: a point, a segment or a rectangle, and a radius.

#include "02_primitives/shapes/plane_shapes.hpp"
#include "common/math/norm.hpp"
#include "common/math/wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <span>

namespace cookbook
{

/// A vector turned by a quarter, counter-clockwise.
template <class Real>
Vector<Real, 2> quarter_turn(const Vector<Real, 2>& v)
{
  return {-v.y(), v.x()};
}

/// The area of the parallelogram of two vectors; above zero where b is to the left of a.
template <class Real>
Real cross_in_plane(const Vector<Real, 2>& a, const Vector<Real, 2>& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// The direction of a vector of any length; of zero it is +y.
template <class Real>
Vector<Real, 2> unit_in_plane(const Vector<Real, 2>& v)
{
  return normalize<Real>(Vector3<Real>(v.x(), v.y(), Real(0))).unit.template head<2>();
}

// [plane_form]
/// A point, a segment or a rectangle, and all that is within `radius` of it.
template <class Real>
struct PlaneForm
{
  std::array<Vector<Real, 2>, 4> corner; ///< [m], counter-clockwise; the first `corners` are used
  int corners;                           ///< 1, 2 or 4
  Vector<Real, 2> center;                ///< [m]; of a segment its start
  Vector<Real, 2> axis;                  ///< [1], unit: the rectangle's first axis
  Vector<Real, 2> half;                  ///< [m], half extents
  Real radius;                           ///< [m]

  /// The corners that are used.
  std::span<const Vector<Real, 2>> polygon() const
  {
    return std::span(corner).first(std::size_t(corners));
  }
};
// [plane_form]

/// The largest of a shape's lengths and coordinates, without sign.
template <class Real>
Real largest(const Vector<Real, 2>& point)
{
  return point.cwiseAbs().maxCoeff();
}

/// The largest of a segment's coordinates, without sign.
template <class Real>
Real largest(const Segment2<Real>& segment)
{
  return std::max(largest(segment.start), largest(segment.end));
}

/// The largest of a circle's numbers, without sign.
template <class Real>
Real largest(const Circle<Real>& circle)
{
  return std::max(largest(circle.center), circle.radius);
}

/// The largest of a rectangle's lengths and coordinates, without sign.
template <class Real>
Real largest(const Rectangle<Real>& rectangle)
{
  return std::max(largest(rectangle.center), largest(rectangle.half_extents));
}

/// The largest of a turned rectangle's lengths and coordinates, without sign.
template <class Real>
Real largest(const OrientedRectangle<Real>& rectangle)
{
  return std::max(largest(rectangle.center), largest(rectangle.half_extents));
}

/// The power of two that brings a size to about one; 0 for sizes whose fourth powers fit anyway.
template <class Real>
int exponent_to_ordinary(const Real& size)
{
  const Real most = std::ldexp(Real(1), std::numeric_limits<Real>::max_exponent / 5);
  const bool ordinary = size >= Real(1) / most && size <= most;
  const bool has_one = size > Real(0) && size <= std::numeric_limits<Real>::max();
  const int powers = std::numeric_limits<Real>::max_exponent - 3;
  return ordinary || !has_one ? 0 : std::clamp(-std::ilogb(size), -powers, powers);
}

/// Where from and how large shapes are seen while they are computed with.
template <class Real>
struct PlaneView
{
  Vector<Wide<Real>, 2> origin; ///< [m / factor], what is subtracted
  int exponent;                 ///< of the power of two
  Wide<Real> factor;            ///< 2^exponent

  /// A view from a point that shapes of this size have ordinary numbers in.
  PlaneView(const Vector<Real, 2>& from, const Real& size)
      : exponent(exponent_to_ordinary<Wide<Real>>(size)),
        factor(std::ldexp(Wide<Real>(1), exponent))
  {
    origin = widen(from) * factor;
  }

  /// A point as it is seen.
  Vector<Wide<Real>, 2> seen(const Vector<Real, 2>& point) const
  {
    return widen(point) * factor - origin;
  }

  /// A seen length as it is.
  Real length(const Wide<Real>& as_seen) const
  {
    return static_cast<Real>(std::ldexp(as_seen, -exponent));
  }

  /// A seen point as it is.
  ///
  /// Never inlined: where g++ 12 from -O2 on sees two doubles rounded to float and widened again in
  /// one vectorised piece, it drops the rounding.
  [[gnu::noinline]] Vector<Real, 2> point(const Vector<Wide<Real>, 2>& as_seen) const
  {
    const Vector<Wide<Real>, 2> at = as_seen + origin;
    return {length(at.x()), length(at.y())};
  }
};

} // namespace cookbook
