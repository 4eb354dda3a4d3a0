#pragma once

/// \file
/// \brief The rectangle along the axes around points, and around shapes in the plane.

#include "02_primitives/in_the_plane/in_the_plane.hpp"

#include <cmath>
#include <limits>
#include <span>

namespace cookbook
{

/// The smallest number of a type that is not below a number of the wider type.
template <class Real>
Real rounded_up(const Wide<Real>& x)
{
  const Real nearest = static_cast<Real>(x);
  return Wide<Real>(nearest) < x ? std::nextafter(nearest, std::numeric_limits<Real>::infinity())
                                 : nearest;
}

// [bounding_rectangle]
/// Half extents that reach from zero to `least` and `most`, times 2^-exponent, rounded outwards.
template <class Real>
Vector<Real, 2>
half_between(const Vector<Wide<Real>, 2>& least, const Vector<Wide<Real>, 2>& most, int exponent)
{
  const Vector<Wide<Real>, 2> half = most.cwiseMax(-least);
  return {
      rounded_up<Real>(std::ldexp(half.x(), -exponent)),
      rounded_up<Real>(std::ldexp(half.y(), -exponent))};
}

/// The smallest rectangle along the axes around points, of which there is at least one.
template <class Real>
Rectangle<Real> bounding_rectangle(std::span<const Vector<Real, 2>> points)
{
  Vector<Real, 2> least = points[0], most = points[0];
  for (const Vector<Real, 2>& point : points)
  {
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const Real size = std::max(largest(least), largest(most));
  const PlaneView<Real> view(least, size);
  Rectangle<Real> around{view.point(view.seen(most) / 2), {0, 0}};
  const PlaneView<Real> from_center(around.center, size);
  around.half_extents =
      half_between<Real>(from_center.seen(least), from_center.seen(most), from_center.exponent);
  return around;
}

/// The smallest rectangle along the axes around a shape in the plane.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> Rectangle<Real>
bounding_rectangle(const Shape<Real>& shape)
{
  const PlaneView<Real> view(place_of(shape), largest(shape));
  const PlaneForm<Wide<Real>> form = form_of(shape, view);
  Vector<Wide<Real>, 2> least = form.corner[0], most = least;
  for (const Vector<Wide<Real>, 2>& corner : form.polygon())
  {
    least = least.cwiseMin(corner);
    most = most.cwiseMax(corner);
  }
  const Vector<Wide<Real>, 2> radius(form.radius, form.radius);
  Rectangle<Real> around{view.point(least / 2 + most / 2), {0, 0}};
  const Vector<Wide<Real>, 2> center = view.seen(around.center);
  around.half_extents =
      half_between<Real>(least - radius - center, most + radius - center, view.exponent);
  return around;
}
// [bounding_rectangle]

} // namespace cookbook
