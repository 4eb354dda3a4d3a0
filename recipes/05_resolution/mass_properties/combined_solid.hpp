#pragma once

/// \file
/// \brief Mass, centre and principal axes of several solids that hold together.

#include "05_resolution/mass_properties/mass_properties.hpp"

#include <Eigen/Eigenvalues>

#include <limits>
#include <vector>

namespace cookbook
{

// [placed_solid]
/// A solid and where it is in a common frame.
template <class Real>
struct PlacedSolid
{
  MassProperties<Real> properties; ///< about its own centre, along its own axes
  Vector3<Real> center;            ///< [m], of mass
  Matrix3<Real> axes;              ///< [1], columns are the unit axes that the moments belong to
};

/// The inertia [kg m²] of a solid about any point [m], along the axes of the common frame; M12,
/// M13.
template <class Real>
Matrix3<Real> inertia_about(const PlacedSolid<Real>& solid, const Vector3<Real>& point)
{
  const Vector3<Real> d = solid.center - point;
  const Matrix3<Real> apart = d.dot(d) * Matrix3<Real>::Identity() - d * d.transpose();
  return world_inertia(solid.properties.moments, solid.axes) + solid.properties.mass * apart;
}
// [placed_solid]

// [together]
/// The mass [kg] of several solids together.
template <class Real>
Real mass_together(const std::vector<PlacedSolid<Real>>& solids)
{
  Real mass = Real(0);
  for (const PlacedSolid<Real>& solid : solids)
  {
    mass += solid.properties.mass;
  }
  return mass;
}

/// The centre of mass [m] of several solids; at least one is needed.
template <class Real>
Vector3<Real> center_together(const std::vector<PlacedSolid<Real>>& solids)
{
  const Real mass = mass_together(solids);
  Vector3<Real> center = Vector3<Real>::Zero();
  for (const PlacedSolid<Real>& solid : solids)
  {
    center += Real(solid.properties.mass / mass) * solid.center;
  }
  return center;
}

/// The inertia [kg m²] of several solids about their centre of mass, along the common axes.
template <class Real>
Matrix3<Real> inertia_together(const std::vector<PlacedSolid<Real>>& solids)
{
  const Vector3<Real> center = center_together(solids);
  Matrix3<Real> inertia = Matrix3<Real>::Zero();
  for (const PlacedSolid<Real>& solid : solids)
  {
    inertia += inertia_about(solid, center);
  }
  return inertia;
}
// [together]

// [combined]
/// Eigenvectors as the axes of a body: right-handed, the largest part of the first two positive.
template <class Real>
Matrix3<Real> right_handed(Matrix3<Real> axes)
{
  for (int i = 0; i < 2; ++i)
  {
    Eigen::Index largest = 0;
    axes.col(i).cwiseAbs().maxCoeff(&largest);
    axes.col(i) *= axes(largest, i) < Real(0) ? Real(-1) : Real(1);
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

/// Several solids that hold together as one: mass, centre of mass, principal axes; at least one is
/// needed.
///
/// The axes are those of the smallest, the middle and the largest moment. Where moments are equal,
/// any axes across the others will do. A moment that is lost in the rounding of the largest, as
/// that of a needle about its length, is no less than that rounding.
template <class Real>
PlacedSolid<Real> combined(const std::vector<PlacedSolid<Real>>& solids)
{
  const Matrix3<Real> inertia = inertia_together(solids);
  const Eigen::SelfAdjointEigenSolver<Matrix3<Real>> principal(inertia);
  const Real least = std::numeric_limits<Real>::epsilon() * principal.eigenvalues().maxCoeff();
  const Vector3<Real> moments = principal.eigenvalues().cwiseMax(least);
  return {
      {mass_together(solids), moments},
      center_together(solids),
      right_handed<Real>(principal.eigenvectors())};
}
// [combined]

} // namespace cookbook
