#pragma once

/// \file
/// \brief A spring with a damper between two points: its force, and the period of a mass on it.

#include "common/math/norm.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [spring]
/// A spring with a damper beside it.
template <class Real>
struct Spring
{
  Real stiffness;   ///< [N/m], k, zero or more
  Real damping;     ///< [N s/m], c, zero or more
  Real rest_length; ///< [m], at which it neither pulls nor pushes
};

/// The force [N] on the far end of a spring, from the arm [m] that reaches there from the near end
/// and from the velocity [m/s] of the far end as seen from the near one; R30.
///
/// An arm of length zero has no direction; it is taken to point up, along +y.
template <class Real>
Vector3<Real>
spring_force(const Spring<Real>& spring, const Vector3<Real>& arm, const Vector3<Real>& velocity)
{
  const Direction<Real> along_arm = normalize(arm);
  const Real stretch = along_arm.length - spring.rest_length;
  const Real speed = velocity.dot(along_arm.unit);
  return -(spring.stiffness * stretch + spring.damping * speed) * along_arm.unit;
}

/// The period [s] of a mass [kg] on an undamped spring; R30. Infinite without stiffness.
template <class Real>
Real spring_period(const Spring<Real>& spring, const Real& mass)
{
  using std::sqrt;
  return Real(2) * std::numbers::pi_v<Real> * sqrt(mass / spring.stiffness);
}
// [spring]

} // namespace cookbook
