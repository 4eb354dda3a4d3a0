#pragma once

/// \file
/// \brief The manifold of a sphere and an oriented box.

#include "02_primitives/closest_point_box/closest_point_box.hpp"
#include "03_sphere_manifolds/manifold/any_size_spheres.hpp"
#include "03_sphere_manifolds/manifold/translated.hpp"
#include "03_sphere_manifolds/sphere_sphere/sphere_sphere.hpp"

namespace cookbook
{

// [direction_to_box]
/// Direction and signed distance [m] to the surface of a box, from a point given by its coordinates
/// `local` along the box's axes; S7, S8.
template <class Real>
Direction<Real> direction_to_box(
    const Vector3<Wide<Real>>& local, const Matrix3<Real>& axes, const Vector3<Real>& half_extents)
{
  const Direction<Wide<Real>> out = signed_distance_box<Wide<Real>>(local, widen(half_extents));
  const Vector3<Wide<Real>> unit = widen(axes) * -out.unit;
  return {unit.template cast<Real>(), static_cast<Real>(out.length)};
}
// [direction_to_box]

// [sphere_box_relative]
/// The manifold of a sphere and a box in the sphere's frame, where its centre is the origin.
///
/// For worlds far from the origin: keep positions in double, and pass their difference [m].
template <class Real>
std::optional<Manifold<Real>> sphere_box_relative(
    const Vector3<Wide<Real>>& sphere_to_box, Real radius, const Matrix3<Real>& axes,
    const Vector3<Real>& half_extents)
{
  const Vector3<Wide<Real>> local = widen(axes).transpose() * -sphere_to_box;
  return overlap_manifold<Real>(
      sphere_overlap(direction_to_box(local, axes, half_extents), radius, Real(0)),
      Vector3<Real>::Zero());
}
// [sphere_box_relative]

// [sphere_box]
/// The manifold of a sphere A and a box B, also where the sphere's centre is inside the box.
///
/// The normal points from the sphere into the box. Outside, the sphere leaves by the way it came
/// closest; inside, through the nearest face, by its whole radius and the way to that face.
/// Touching is contact of depth zero. A centre equally near to several faces takes the first axis
/// of x, y, z and its positive side.
template <class Real>
std::optional<Manifold<Real>> sphere_box(const Sphere<Real>& sphere, const Obb<Real>& box)
{
  const auto find = [](const Sphere<Real>& a, const Obb<Real>& b)
  {
    const Vector3<Wide<Real>> sphere_to_box = widen(b.center) - widen(a.center);
    return translated(
        sphere_box_relative<Real>(sphere_to_box, a.radius, b.axes, b.half_extents), a.center);
  };
  return at_any_size(sphere, box, sums_fit<Real>, find);
}
// [sphere_box]

} // namespace cookbook
