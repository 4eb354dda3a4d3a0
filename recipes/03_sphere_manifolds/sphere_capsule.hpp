#pragma once

/// \file
/// \brief The manifold of a sphere and a capsule.

#include "03_sphere_manifolds/any_size.hpp"
#include "03_sphere_manifolds/sphere_sphere.hpp"
#include "common/math/wide.hpp"

#include <algorithm>

namespace cookbook
{

// [closest_point_segment]
/// The point of a segment closest to `point`, both [m], world; a segment of length zero is its own
/// answer; P2.
template <class Real>
Vector3<Wide<Real>> closest_point(const Segment<Real>& segment, const Vector3<Real>& point)
{
  const Vector3<Wide<Real>> start = widen(segment.start);
  const Vector3<Wide<Real>> along = widen(segment.end) - start;
  const Wide<Real> along_squared = along.squaredNorm();
  if (along_squared == Wide<Real>(0))
  {
    return start;
  }
  const Wide<Real> t = (widen(point) - start).dot(along) / along_squared;
  return start + std::clamp(t, Wide<Real>(0), Wide<Real>(1)) * along;
}
// [closest_point_segment]

// [sphere_capsule]
/// The manifold of a sphere A and a capsule B: the sphere against the one ball of the capsule whose
/// centre is closest.
///
/// A sphere centred on the capsule's own segment parts from it along +y.
template <class Real>
std::optional<Manifold<Real>>
sphere_capsule(const Sphere<Real>& sphere, const Capsule<Real>& capsule)
{
  const auto find = [](const Sphere<Real>& a, const Capsule<Real>& b)
  {
    const Vector3<Wide<Real>> closest = closest_point(b.segment, a.center);
    const Vector3<Real> to_closest = (closest - widen(a.center)).template cast<Real>();
    return translated(sphere_sphere_relative<Real>(to_closest, a.radius, b.radius), a.center);
  };
  return at_any_size(sphere, capsule, squares_fit<Real>, find);
}
// [sphere_capsule]

} // namespace cookbook
