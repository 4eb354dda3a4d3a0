#pragma once

/// \file
/// \brief From the world to a pixel, and frustum culling: the formulas as they stand.

#include "02_primitives/camera/frustum.hpp"
#include "02_primitives/shape_bounds/box_radius.hpp"

#include <algorithm>
#include <optional>

namespace cookbook
{

// [pixel_of]
/// The pixel at which a point [m], world, is seen; nothing for what is not ahead of the camera.
///
/// `clip_from_world` takes points of the world to clip space, `size` is that of the picture.
template <class Real>
std::optional<Vector2<Real>>
pixel_of(const Matrix4<Real>& clip_from_world, const Vector2<Real>& size, const Vector3<Real>& p)
{
  const Vector<Real, 4> clip = clip_from_world * p.homogeneous();
  if (!(clip.w() > Real(0)))
  {
    return std::nullopt;
  }
  const Vector3<Real> ndc = clip.template head<3>() / clip.w(); // the perspective divide
  return Vector2<Real>((1 + ndc.x()) / 2 * size.x(), (1 - ndc.y()) / 2 * size.y());
}
// [pixel_of]

// [is_culled]
/// Whether a sphere is out of view: all of it is above one of the six planes.
template <class Real>
bool is_culled(const Frustum<Real>& frustum, const Sphere<Real>& sphere)
{
  return std::any_of(
      frustum.planes.begin(), frustum.planes.end(),
      [&](const Plane<Real>& plane)
      { return plane.normal.dot(sphere.center) - plane.distance > sphere.radius; });
}

/// Whether an oriented box is out of view: its projected radius stands in for a sphere's.
template <class Real>
bool is_culled(const Frustum<Real>& frustum, const Obb<Real>& box)
{
  return std::any_of(
      frustum.planes.begin(), frustum.planes.end(),
      [&](const Plane<Real>& plane)
      { return plane.normal.dot(box.center) - plane.distance > box_radius(box, plane.normal); });
}
// [is_culled]

} // namespace cookbook
