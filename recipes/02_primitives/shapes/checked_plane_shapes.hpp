#pragma once

/// \file
/// \brief The check that the numbers of a shape in the plane make sense.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "02_primitives/shapes/plane_shapes.hpp"

namespace cookbook
{

/// Throws InvalidShape unless both half extents are finite and not negative.
template <class Real>
void check_extents_in_plane(const Vector<Real, 2>& half_extents)
{
  check_finite("half_extents", half_extents);
  const char* const names[] = {"half_extents.x", "half_extents.y"};
  for (int i = 0; i < 2; ++i)
  {
    if (half_extents[i] < Real(0))
    {
      throw InvalidShape(names[i], "zero or more", text_of(half_extents[i]));
    }
  }
}

/// The segment itself, or InvalidShape; it may have no length.
template <class Real>
const Segment2<Real>& checked(const Segment2<Real>& segment)
{
  check_finite("start", segment.start);
  check_finite("end", segment.end);
  return segment;
}

/// The ray itself, or InvalidShape: its direction must not be zero.
template <class Real>
const Ray2<Real>& checked(const Ray2<Real>& ray)
{
  check_finite("origin", ray.origin);
  check_finite("direction", ray.direction);
  if (ray.direction.isZero(0))
  {
    throw InvalidShape("direction", "other than zero", "(0, 0)");
  }
  return ray;
}

/// The circle itself, or InvalidShape; a radius of zero makes a point.
template <class Real>
const Circle<Real>& checked(const Circle<Real>& circle)
{
  check_finite("center", circle.center);
  check_radius(circle.radius);
  return circle;
}

/// The rectangle itself, or InvalidShape; it may be flat.
template <class Real>
const Rectangle<Real>& checked(const Rectangle<Real>& rectangle)
{
  check_finite("center", rectangle.center);
  check_extents_in_plane(rectangle.half_extents);
  return rectangle;
}

/// The turned rectangle itself, or InvalidShape; it may be flat.
template <class Real>
const OrientedRectangle<Real>& checked(const OrientedRectangle<Real>& rectangle)
{
  check_finite("center", rectangle.center);
  check_finite("angle", rectangle.angle);
  check_extents_in_plane(rectangle.half_extents);
  return rectangle;
}

} // namespace cookbook
