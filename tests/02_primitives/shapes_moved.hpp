/// \file
/// Shapes of every kind, moved.
#pragma once

#include "02_primitives/shapes/more_shapes.hpp"

namespace cookbook
{

/// A shape, moved.
template <class Real>
Vector3<Real> moved(const Vector3<Real>& p, const Vector3<Real>& by)
{
  return p + by;
}
template <class Real>
Segment<Real> moved(const Segment<Real>& s, const Vector3<Real>& by)
{
  return {s.start + by, s.end + by};
}
template <class Real>
Plane<Real> moved(const Plane<Real>& plane, const Vector3<Real>& by)
{
  return {plane.normal, plane.distance + plane.normal.dot(by)};
}
template <class Real>
Sphere<Real> moved(const Sphere<Real>& s, const Vector3<Real>& by)
{
  return {s.center + by, s.radius};
}
template <class Real>
Capsule<Real> moved(const Capsule<Real>& c, const Vector3<Real>& by)
{
  return {moved(c.segment, by), c.radius};
}
template <class Real>
Aabb<Real> moved(const Aabb<Real>& box, const Vector3<Real>& by)
{
  return Aabb<Real>(box.min() + by, box.max() + by);
}
template <class Real>
Obb<Real> moved(const Obb<Real>& box, const Vector3<Real>& by)
{
  return {box.center + by, box.axes, box.half_extents};
}
template <class Real>
Triangle<Real> moved(const Triangle<Real>& t, const Vector3<Real>& by)
{
  return {t.a + by, t.b + by, t.c + by};
}
template <class Real>
Tetrahedron<Real> moved(const Tetrahedron<Real>& t, const Vector3<Real>& by)
{
  return {t.a + by, t.b + by, t.c + by, t.d + by};
}

} // namespace cookbook
