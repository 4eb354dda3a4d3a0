#pragma once

/// \file
/// \brief Circles around points, and around shapes in the plane.

#include "02_primitives/bounding_circle/bounding_rectangle.hpp"
#include "02_primitives/bounding_circle/resting_circle.hpp"

#include <span>

namespace cookbook
{

/// A view of points from the first of them.
template <class Real>
PlaneView<Real> view_of(std::span<const Vector<Real, 2>> points)
{
  Real size = 0;
  for (const Vector<Real, 2>& point : points)
  {
    size = std::max(size, largest(point));
  }
  return {points[0], size};
}

/// The circle about a centre, as it is seen, that reaches to the farthest of the points.
///
/// Its centre is rounded first, then the radius, upwards, so that it holds them all, to the bit.
template <class Real>
Circle<Real> circle_around(
    const Vector<Wide<Real>, 2>& center, std::span<const Vector<Real, 2>> points,
    const PlaneView<Real>& view)
{
  Circle<Real> circle{view.point(center), Real(0)};
  PlaneView<Real> from_center = view;
  from_center.origin = widen(circle.center) * view.factor;
  for (const Vector<Real, 2>& point : points)
  {
    circle.radius = std::max(circle.radius, from_center.length(from_center.seen(point).norm()));
  }
  for (const Vector<Real, 2>& point : points)
  {
    for (int roundings = 0; roundings < 4 && !contains<Real>(circle, point); ++roundings)
    {
      circle.radius = std::nextafter(circle.radius, std::numeric_limits<Real>::infinity());
    }
  }
  return circle;
}

// [centroid_circle]
/// The circle about the mean of points, of which there is at least one; P22.
template <class Real>
Circle<Real> centroid_circle(std::span<const Vector<Real, 2>> points)
{
  const PlaneView<Real> view = view_of<Real>(points);
  Vector<Wide<Real>, 2> sum(0, 0);
  for (const Vector<Real, 2>& point : points)
  {
    sum += view.seen(point);
  }
  return circle_around<Real>(sum / Wide<Real>(points.size()), points, view);
}
// [centroid_circle]

// [minimal_circle]
/// The smallest circle around points, of which there is at least one; P22.
template <class Real>
Circle<Real> minimal_circle(std::span<const Vector<Real, 2>> points)
{
  const PlaneView<Real> view = view_of<Real>(points);
  const auto seen = [&](std::size_t i) { return view.seen(points[i]); };
  const auto circle = growing_circle<Wide<Real>>(points.size(), seen);
  return circle_around<Real>(circle.center, points, view);
}
// [minimal_circle]

// [bounding_circle]
/// The smallest circle around a shape in the plane; its radius is rounded upwards.
template <class Real, template <class> class Shape>
requires ShapeInPlane<Shape<Real>, Real> Circle<Real> bounding_circle(const Shape<Real>& shape)
{
  const PlaneView<Real> view(place_of(shape), largest(shape));
  const PlaneForm<Wide<Real>> form = form_of(shape, view);
  const auto corner = [&](std::size_t i) { return form.corner[i]; };
  const auto inner = growing_circle<Wide<Real>>(std::size_t(form.corners), corner);
  Circle<Real> circle{view.point(inner.center), Real(0)};
  Wide<Real> radius = 0;
  for (const Vector<Wide<Real>, 2>& at : form.polygon())
  {
    radius = std::max(radius, (at - view.seen(circle.center)).norm());
  }
  circle.radius = rounded_up<Real>(std::ldexp(radius + form.radius, -view.exponent));
  return circle;
}
// [bounding_circle]

} // namespace cookbook
