#pragma once

/// \file
/// \brief When a moving sphere first touches a box, a plane or another sphere.

#include "03_sphere_manifolds/sphere_box/sphere_box.hpp"
#include "03_sphere_manifolds/sphere_plane/sphere_plane.hpp"
#include "05_resolution/tunnelling/first_touch.hpp"

#include <limits>
#include <optional>

namespace cookbook
{

/// How far [m] rounding may move the gap of a sphere from something of this size [m].
template <class Real>
Wide<Real> sweep_rounding(
    const Vector3<Wide<Real>>& start, const Vector3<Wide<Real>>& displacement, Wide<Real> size)
{
  const Wide<Real> sum = start.cwiseAbs().maxCoeff() + displacement.cwiseAbs().maxCoeff() + size;
  return Wide<Real>(16) * std::numeric_limits<Wide<Real>>::epsilon() * sum;
}

/// A hit in the number type of the shapes.
template <class Real>
std::optional<SweptHit<Real>>
narrowed(const std::optional<SweptHit<Wide<Real>>>& hit, const Matrix3<Wide<Real>>& axes)
{
  if (!hit)
  {
    return std::nullopt;
  }
  const Vector3<Wide<Real>> normal = axes * hit->normal;
  return SweptHit<Real>{static_cast<Real>(hit->time), normal.template cast<Real>()};
}

// [swept_sphere_box]
/// The first touch of a sphere that moves by a displacement [m], as seen from a box.
///
/// Nothing where they do not touch within the displacement, separate from the start, or stand
/// still. All numbers are finite and their squares too.
template <class Real>
std::optional<SweptHit<Real>> swept_sphere_box(
    const Sphere<Real>& sphere, const Vector3<Real>& displacement, const Obb<Real>& box)
{
  using Vector = Vector3<Wide<Real>>;
  const Vector start = box_coordinates(box, sphere.center), half = widen(box.half_extents);
  const Vector path = widen(box.axes).transpose() * widen(displacement);
  const Wide<Real> radius = sphere.radius;
  const auto gap = [&](const Vector& offset)
  {
    const Direction<Wide<Real>> out = signed_distance_box<Wide<Real>>(start + offset, half);
    return Direction<Wide<Real>>{-out.unit, out.length - radius};
  };
  const Wide<Real> rounding = sweep_rounding<Real>(start, path, half.maxCoeff() + radius);
  return narrowed<Real>(first_touch<Wide<Real>>(path, rounding, gap), widen(box.axes));
}
// [swept_sphere_box]

/// The same of the solid below a plane.
template <class Real>
std::optional<SweptHit<Real>> swept_sphere_plane(
    const Sphere<Real>& sphere, const Vector3<Real>& displacement, const Plane<Real>& plane)
{
  using Vector = Vector3<Wide<Real>>;
  const Vector normal = widen(plane.normal), path = widen(displacement);
  const Plane<Wide<Real>> wide{widen(plane.normal), plane.distance};
  const Wide<Real> start = signed_distance<Wide<Real>>(wide, widen(sphere.center));
  const Wide<Real> radius = sphere.radius;
  const auto gap = [&](const Vector& offset) {
    return Direction<Wide<Real>>{-normal, start - radius + normal.dot(offset)};
  };
  const Wide<Real> size = widen(sphere.center).cwiseAbs().maxCoeff() + radius;
  const Wide<Real> rounding = sweep_rounding<Real>(Vector::Zero(), path, size);
  return narrowed<Real>(
      first_touch<Wide<Real>>(path, rounding, gap), Matrix3<Wide<Real>>::Identity());
}

/// The same of a second sphere; concentric ones part along +y.
template <class Real>
std::optional<SweptHit<Real>> swept_sphere_sphere(
    const Sphere<Real>& sphere, const Vector3<Real>& displacement, const Sphere<Real>& other)
{
  using Vector = Vector3<Wide<Real>>;
  const Vector start = widen(other.center) - widen(sphere.center), path = widen(displacement);
  const Wide<Real> radius_bound = Wide<Real>(sphere.radius) + Wide<Real>(other.radius);
  const auto gap = [&](const Vector& offset)
  {
    const Direction<Wide<Real>> direction = normalize<Wide<Real>>(start - offset);
    return Direction<Wide<Real>>{direction.unit, direction.length - radius_bound};
  };
  const Wide<Real> rounding = sweep_rounding<Real>(start, path, radius_bound);
  return narrowed<Real>(
      first_touch<Wide<Real>>(path, rounding, gap), Matrix3<Wide<Real>>::Identity());
}

} // namespace cookbook
