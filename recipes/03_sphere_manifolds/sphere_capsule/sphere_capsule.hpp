#pragma once

/// \file
/// \brief The manifold of a sphere and a capsule.

#include "02_primitives/plain_points/plain_points.hpp"
#include "03_sphere_manifolds/manifold/any_size_spheres.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"
#include "common/math/wide.hpp"

namespace cookbook
{

// [direction_to_segment]
/// The direction perpendicular to `along`, of length one, that is closest to +y; to +x where
/// `along` is ±y.
template <class Real>
Vector3<Real> perpendicular_to(const Vector3<Real>& along)
{
  const Vector3<Real> up = along.cross(Vector3<Real>::UnitY()).cross(along);
  return normalize<Real>(up, Vector3<Real>::UnitX()).unit;
}

/// Direction and distance [m] from a point to a segment; perpendicular_to() from a point on it.
///
/// From beside the segment the direction is perpendicular to it. A point that is on the segment but
/// for rounding has a way to it that is nothing but rounding, and may lead along the segment.
template <class Real>
Direction<Real> direction_to(const Segment<Real>& segment, const Vector3<Real>& point)
{
  using Vector = Vector3<Wide<Real>>;
  const Segment<Wide<Real>> wide{widen(segment.start), widen(segment.end)};
  const Vector along = normalize<Wide<Real>>(wide.end - wide.start, Vector::UnitX()).unit;
  const Wide<Real> fraction = closest_t<Wide<Real>>(wide, widen(point));
  const Vector way = closest_point<Wide<Real>>(wide, widen(point)) - widen(point);
  Direction<Wide<Real>> to = normalize<Wide<Real>>(way, perpendicular_to<Wide<Real>>(along));
  if (Wide<Real>(0) < fraction && fraction < Wide<Real>(1))
  {
    const Vector perpendicular = to.unit - to.unit.dot(along) * along;
    const bool certain = perpendicular.squaredNorm() > Wide<Real>(0.25);
    to.unit = certain ? perpendicular.normalized() : perpendicular_to<Wide<Real>>(along);
  }
  return {to.unit.template cast<Real>(), static_cast<Real>(to.length)};
}
// [direction_to_segment]

// [sphere_capsule]
/// The manifold of a sphere A and a capsule B: the sphere against the one ball of the capsule whose
/// centre is closest.
///
/// A sphere centred on the capsule's own segment leaves along perpendicular_to(), by both radii.
template <class Real>
std::optional<Manifold<Real>>
sphere_capsule(const Sphere<Real>& sphere, const Capsule<Real>& capsule)
{
  const auto find = [](const Sphere<Real>& a, const Capsule<Real>& b)
  {
    const Direction<Real> to_axis = direction_to(b.segment, a.center);
    return overlap_manifold(sphere_overlap(to_axis, a.radius, b.radius), a.center);
  };
  return at_any_size(sphere, capsule, squares_fit<Real>, find);
}
// [sphere_capsule]

} // namespace cookbook
