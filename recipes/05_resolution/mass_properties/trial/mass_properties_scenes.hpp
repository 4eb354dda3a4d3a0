#pragma once

/// \file
/// \brief Solids that hold together: cubes, balls on a stick, a rod that leans, an axe.

#include "05_resolution/mass_properties/combined_solid.hpp"
#include "common/math/rotation.hpp"

#include <vector>

namespace cookbook
{

/// A solid that is not turned, with its centre of mass at a place [m].
template <class Real>
PlacedSolid<Real> upright(const MassProperties<Real>& properties, const Vector3<Real>& center)
{
  return {properties, center, Matrix3<Real>::Identity()};
}

/// A cube of 1 kg and side 1 m.
template <class Real>
MassProperties<Real> one_cube()
{
  return solid_box<Real>(1, Vector3<Real>::Constant(Real(1) / Real(2)));
}

/// Eight cubes of 1 kg and side 1 m that make one of side 2 m.
template <class Real>
std::vector<PlacedSolid<Real>> eight_cubes()
{
  std::vector<PlacedSolid<Real>> solids;
  for (int i = 0; i < 8; ++i)
  {
    const Real half = Real(1) / Real(2);
    const Vector3<Real> center(
        i & 1 ? half : Real(-half), i & 2 ? half : Real(-half), i & 4 ? half : Real(-half));
    solids.push_back(upright<Real>(one_cube<Real>(), center));
  }
  return solids;
}

/// Two balls of 1 kg and radius 1/2 m at x = -2 m and x = 2 m, held by a stick without mass.
template <class Real>
std::vector<PlacedSolid<Real>> dumbbell()
{
  const MassProperties<Real> ball = solid_sphere<Real>(1, Real(1) / Real(2));
  return {
      upright<Real>(ball, Vector3<Real>(-2, 0, 0)), upright<Real>(ball, Vector3<Real>(2, 0, 0))};
}

/// Three cubes of 1 kg and side 1 m that make an L: at the origin, beside it and above it.
template <class Real>
std::vector<PlacedSolid<Real>> three_cubes()
{
  return {
      upright<Real>(one_cube<Real>(), Vector3<Real>(0, 0, 0)),
      upright<Real>(one_cube<Real>(), Vector3<Real>(1, 0, 0)),
      upright<Real>(one_cube<Real>(), Vector3<Real>(0, 1, 0))};
}

/// A rod of 3 kg, 2 m by 0.2 m by 0.2 m, that leans in the plane of x and y: 4 up for 3 along.
template <class Real>
std::vector<PlacedSolid<Real>> leaning_rod()
{
  const Real thin = Real(1) / Real(10);
  const MassProperties<Real> rod = solid_box<Real>(3, Vector3<Real>(1, thin, thin));
  return {{rod, Vector3<Real>::Zero(), rational_rotation<Real>(2, 0, 0, 1)}};
}

/// A box of an axe, as it is drawn.
struct AxePart
{
  PlacedSolid<double> solid;
  Vector3<double> half_extents; ///< [m]
};

/// An axe: a handle of 0.8 kg, 0.8 m long, along y, and a head [kg] on one side of its upper end.
inline std::vector<AxePart> axe(double head)
{
  const Vector3<double> handle(0.02, 0.4, 0.02), blade(0.1, 0.06, 0.02);
  return {
      {upright<double>(solid_box(0.8, handle), {0, 0, 0}), handle},
      {upright<double>(solid_box(head, blade), {0.12, 0.34, 0}), blade}};
}

} // namespace cookbook
