#pragma once

/// \file
/// \brief Mass and moments of inertia of solids, and of several solids that hold together.

#include "05_resolution/mass_properties/solid_mass.hpp"

namespace cookbook
{

// [capsule]
/// A solid capsule of even density along the body's y axis: mass [kg], length [m] of its segment,
/// radius [m], greater than zero; R26.
///
/// A length of zero makes a ball.
template <class Real>
MassProperties<Real> solid_capsule(Real mass, Real length, Real radius)
{
  const Real middle = mass * (length / (length + Real(4) / Real(3) * radius));
  const Real ends = mass - middle;
  const Real along = radius * (radius * (middle / Real(2) + ends * Real(2) / Real(5)));
  const Real round = radius * (radius * (middle / Real(4) + ends * Real(2) / Real(5)));
  const Real across = round + length * (length * (middle / Real(12) + ends / Real(4))) +
                      radius * (length * ends * Real(3) / Real(8));
  return {mass, Vector3<Real>(across, along, across)};
}
// [capsule]

// [world_inertia]
/// The inertia [kg m²] in the world of a body whose axes are the columns of a matrix; M12.
template <class Real>
Matrix3<Real> world_inertia(const Vector3<Real>& moments, const Matrix3<Real>& axes)
{
  return axes * moments.asDiagonal() * axes.transpose();
}
// [world_inertia]

} // namespace cookbook
