#pragma once

/// \file
/// \brief The manifold of a sphere and a sphere, or a box: the formulas as they stand, for a room.

#include "02_primitives/shapes/shapes.hpp"
#include "03_sphere_manifolds/manifold/manifold.hpp"

#include <optional>

namespace cookbook
{

// [plain_sphere_sphere]
/// The manifold of two spheres: nothing where they are apart; touching is contact of depth zero.
///
/// S1, S2, S4; concentric spheres separate along +y.
template <class Real>
std::optional<Manifold<Real>> plain_sphere_sphere(const Sphere<Real>& a, const Sphere<Real>& b)
{
  const Vector3<Real> t = b.center - a.center;
  const Real distance = t.norm();
  const Real depth = a.radius + b.radius - distance;
  if (depth < 0)
  {
    return std::nullopt;
  }
  const Vector3<Real> up(0, 1, 0);
  const Vector3<Real> normal = distance > 0 ? Vector3<Real>(t / distance) : up;
  const Vector3<Real> point = a.center + (a.radius - depth / 2) * normal;
  return Manifold<Real>{normal, depth, {{point, depth, 0}}};
}
// [plain_sphere_sphere]

// [plain_sphere_box]
/// The manifold of a sphere A and an oriented box B: through the closest point of the box, or,
/// where the sphere's centre is inside, through the nearest face; S7, S8.
template <class Real>
std::optional<Manifold<Real>> plain_sphere_box(const Sphere<Real>& sphere, const Obb<Real>& box)
{
  const Vector3<Real> local = box.axes.transpose() * (sphere.center - box.center);
  const Vector3<Real> clamped = local.cwiseMax(-box.half_extents).cwiseMin(box.half_extents);
  if (clamped != local) // the centre is outside
  {
    const Vector3<Real> closest = box.center + box.axes * clamped;
    return plain_sphere_sphere<Real>(sphere, {closest, 0});
  }
  int face = 0;
  const Real to_face = (box.half_extents - local.cwiseAbs()).minCoeff(&face);
  const Real depth = sphere.radius + to_face;
  const Vector3<Real> normal = box.axes.col(face) * Real(local[face] < 0 ? 1 : -1);
  const Vector3<Real> point = sphere.center + (sphere.radius - depth / 2) * normal;
  return Manifold<Real>{normal, depth, {{point, depth, 0}}};
}
// [plain_sphere_box]

} // namespace cookbook
