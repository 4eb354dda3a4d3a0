#pragma once

/// \file
/// \brief Restitution in time steps: the speed that two surfaces had as they touched, given back.

#include "05_resolution/impulse/impulse.hpp"
#include "05_resolution/restitution/rebound_speed.hpp"

#include <algorithm>
#include <cmath>

namespace cookbook
{

// [with_separating_velocity]
/// Two bodies after the push that makes them part at a speed [m/s]; as they are where they part as
/// fast already, and where no push moves the point.
template <class Real>
BodyPair<Real> with_separating_velocity(
    BodyPair<Real> bodies, const Vector3<Real>& normal, const Vector3<Real>& point,
    const Real& target)
{
  const Arms<Real> arms = arms_to(bodies, point);
  const Real residual = target - separating_velocity(bodies.a, bodies.b, normal, arms);
  const Real mass = effective_mass(inverse_mass_at(bodies.a, bodies.b, normal, arms));
  apply_impulse<Real>(bodies.a, bodies.b, arms, std::max(Real(0), residual) * mass * normal);
  return bodies;
}
// [with_separating_velocity]

/// How long [s] a ball bounces that is dropped from a height [m]: infinitely often, but not for
/// ever; R19. The restitution [1] is below one.
template <class Real>
Real settling_time(Real height, Real gravity, Real restitution)
{
  using std::sqrt;
  return sqrt(Real(2) * height / gravity) * (Real(1) + restitution) / (Real(1) - restitution);
}

} // namespace cookbook
