#pragma once

/// \file
/// \brief The manifold of two spheres, as the formula stands.

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

} // namespace cookbook
