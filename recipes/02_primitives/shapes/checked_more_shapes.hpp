#pragma once

/// \file
/// \brief The checks of shapes that are made of points alone.

#include "02_primitives/shapes/checked_shapes.hpp"
#include "02_primitives/shapes/more_shapes.hpp"

namespace cookbook
{

/// The segment itself, or InvalidShape; no length is allowed.
template <class Real>
const Segment<Real>& checked(const Segment<Real>& segment)
{
  check_finite("start", segment.start);
  check_finite("end", segment.end);
  return segment;
}

/// The triangle itself, or InvalidShape; a flat one is allowed.
template <class Real>
const Triangle<Real>& checked(const Triangle<Real>& triangle)
{
  check_finite("a", triangle.a);
  check_finite("b", triangle.b);
  check_finite("c", triangle.c);
  return triangle;
}

/// The tetrahedron itself, or InvalidShape; a flat one is allowed.
template <class Real>
const Tetrahedron<Real>& checked(const Tetrahedron<Real>& solid)
{
  check_finite("a", solid.a);
  check_finite("b", solid.b);
  check_finite("c", solid.c);
  check_finite("d", solid.d);
  return solid;
}

/// The box itself, or InvalidShape: its least corner must not be beyond its greatest.
template <class Real>
const Aabb<Real>& checked(const Aabb<Real>& box)
{
  check_finite("min", Vector3<Real>(box.min()));
  check_finite("max", Vector3<Real>(box.max()));
  const char* const names[] = {"max.x", "max.y", "max.z"};
  for (int i = 0; i < 3; ++i)
  {
    if (box.max()[i] < box.min()[i])
    {
      throw InvalidShape(names[i], "min or more, " + text_of(box.min()[i]), text_of(box.max()[i]));
    }
  }
  return box;
}

/// The ray itself, or InvalidShape: it must point somewhere.
template <class Real>
const Ray<Real>& checked(const Ray<Real>& ray)
{
  check_finite("origin", ray.origin);
  check_finite("direction", ray.direction);
  if (ray.direction.isZero(0))
  {
    throw InvalidShape("direction", "other than zero", "0, 0, 0");
  }
  return ray;
}

} // namespace cookbook
