#pragma once

/// \file
/// \brief Two ways to put solids together that lose part of their inertia, kept to be asserted to
/// fail.

#include "05_resolution/mass_properties/combined_solid.hpp"

namespace cookbook
{

// [moments_added]
/// The sum of the solids' own moments, as if all of them turned about their own centres and none of
/// them were turned itself.
template <class Real>
Matrix3<Real> moments_added(const std::vector<PlacedSolid<Real>>& solids)
{
  Matrix3<Real> inertia = Matrix3<Real>::Zero();
  for (const PlacedSolid<Real>& solid : solids)
  {
    inertia += Matrix3<Real>(solid.properties.moments.asDiagonal());
  }
  return inertia;
}
// [moments_added]

// [diagonal_only]
/// The inertia about the common centre without what stands beside its diagonal: right only where
/// the principal axes happen to be those of the frame.
template <class Real>
Matrix3<Real> diagonal_only(const std::vector<PlacedSolid<Real>>& solids)
{
  return inertia_together(solids).diagonal().asDiagonal();
}
// [diagonal_only]

} // namespace cookbook
