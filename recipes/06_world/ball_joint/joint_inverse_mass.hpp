#pragma once

/// \file
/// \brief How two bodies give way to an impulse between two of their points, in all directions.

#include "05_resolution/impulse/contact_impulse.hpp"
#include "05_resolution/spinning_bodies/cross_matrix.hpp"

namespace cookbook
{

// [joint_inverse_mass]
/// How much [1/kg] the points of two bodies at these arms [m] give way to an impulse in between:
/// K = J M⁻¹ Jᵀ; R36.
inline Matrix3<double>
joint_inverse_mass(const Body<double>& a, const Body<double>& b, const Arms<double>& arms)
{
  const auto turning = [](const Body<double>& body, const Vector3<double>& arm)
  {
    const Matrix3<double> s = cross_matrix(arm);
    return Matrix3<double>(s.transpose() * body.inverse_inertia * s);
  };
  const double both = a.inverse_mass + b.inverse_mass;
  return both * Matrix3<double>::Identity() + turning(a, arms.a) + turning(b, arms.b);
}
// [joint_inverse_mass]

} // namespace cookbook
