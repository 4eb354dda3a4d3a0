#pragma once

/// \file
/// \brief The form of each shape in the plane.

#include "02_primitives/in_the_plane/plane_form.hpp"
#include "common/math/trigonometry.hpp"

namespace cookbook
{

/// A point of the shape, from which it is seen best.
template <class Real>
const Vector<Real, 2>& place_of(const Vector<Real, 2>& point)
{
  return point;
}

/// The start.
template <class Real>
const Vector<Real, 2>& place_of(const Segment2<Real>& segment)
{
  return segment.start;
}

/// The center of a circle or a rectangle.
template <class Real, template <class> class Shape>
const Vector<Real, 2>& place_of(const Shape<Real>& shape)
{
  return shape.center;
}

// [forms]
/// A point is a form with one corner.
template <class Real>
PlaneForm<Wide<Real>> form_of(const Vector<Real, 2>& point, const PlaneView<Real>& view)
{
  const Vector<Wide<Real>, 2> at = view.seen(point);
  return {{at, at, at, at}, 1, at, {1, 0}, {0, 0}, 0};
}

/// A segment has two corners.
template <class Real>
PlaneForm<Wide<Real>> form_of(const Segment2<Real>& segment, const PlaneView<Real>& view)
{
  const Vector<Wide<Real>, 2> start = view.seen(segment.start), end = view.seen(segment.end);
  return {{start, end, end, end}, 2, start, {1, 0}, {0, 0}, 0};
}

/// A circle is a point with a radius.
template <class Real>
PlaneForm<Wide<Real>> form_of(const Circle<Real>& circle, const PlaneView<Real>& view)
{
  PlaneForm<Wide<Real>> form = form_of<Real>(circle.center, view);
  form.radius = circle.radius * view.factor;
  return form;
}

/// A rectangle with a given first axis; the second one is a quarter turn further.
template <class Real>
PlaneForm<Real> rectangle_form(
    const Vector<Real, 2>& center, const Vector<Real, 2>& axis, const Vector<Real, 2>& half)
{
  const Vector<Real, 2> x = half.x() * axis, y = half.y() * quarter_turn<Real>(axis);
  return {
      {center - x - y, center + x - y, center + x + y, center - x + y}, 4, center, axis, half, 0};
}

/// A rectangle has four corners.
template <class Real>
PlaneForm<Wide<Real>> form_of(const Rectangle<Real>& rectangle, const PlaneView<Real>& view)
{
  return rectangle_form<Wide<Real>>(
      view.seen(rectangle.center), {1, 0}, widen(rectangle.half_extents) * view.factor);
}

/// A turned rectangle has four corners, too.
template <class Real>
PlaneForm<Wide<Real>> form_of(const OrientedRectangle<Real>& rectangle, const PlaneView<Real>& view)
{
  const SineCosine<Wide<Real>> of = sine_cosine<Wide<Real>>(rectangle.angle);
  return rectangle_form<Wide<Real>>(
      view.seen(rectangle.center), {of.cosine, of.sine},
      widen(rectangle.half_extents) * view.factor);
}
// [forms]

/// The shapes that have a form, each a template on its number type.
template <class Shape, class Real>
concept ShapeInPlane = std::same_as<Shape, Segment2<Real>> || std::same_as<Shape, Circle<Real>> ||
    std::same_as<Shape, Rectangle<Real>> || std::same_as<Shape, OrientedRectangle<Real>>;

} // namespace cookbook
