#pragma once

/// \file
/// \brief Mass and moments of inertia of a solid ball and a solid box.

#include "common/math/vector.hpp"

namespace cookbook
{

// [mass_properties]
/// How hard a solid is to push, and to turn about each of its own axes.
template <class Real>
struct MassProperties
{
  Real mass;             ///< [kg], greater than zero
  Vector3<Real> moments; ///< [kg m²], about the centre of mass, along the body's axes; above zero
};

/// A solid ball of even density: mass [kg], radius [m]; R26.
template <class Real>
MassProperties<Real> solid_sphere(Real mass, Real radius)
{
  const Real moment = Real(2) / Real(5) * mass * radius * radius;
  return {mass, Vector3<Real>::Constant(moment)};
}

/// A solid box of even density: mass [kg], half extents [m]; R26.
template <class Real>
MassProperties<Real> solid_box(Real mass, const Vector3<Real>& half_extents)
{
  const Vector3<Real> along = half_extents.cwiseProduct(half_extents * (mass / Real(3)));
  return {mass, {along.y() + along.z(), along.z() + along.x(), along.x() + along.y()}};
}
// [mass_properties]

} // namespace cookbook
