#pragma once

/// \file
/// \brief One contact point solved as a damped spring, with friction.

#include "05_resolution/contact_constraint/contact_constraint.hpp"
#include "05_resolution/position_correction/softness.hpp"

#include <algorithm>

namespace cookbook
{

// [soft_contact]
/// Solves a contact point once: a damped spring where the surfaces overlap; where they are
/// separated, a stop that lets the gap close within one substep [s], R14. Then its friction, a time
/// [s] after its arms were taken.
template <class Real>
void solve_contact(
    Body<Real>& a, Body<Real>& b, ContactConstraint<Real>& contact, const Softness<Real>& spring,
    const Real& substep, const Real& correction_speed, const Real& elapsed = Real(0))
{
  using std::min;
  const auto closed = contact.separation <= Real(0);
  const Real push_out = min(Real(-spring.bias_rate * contact.separation), correction_speed);
  const Real bias = either(closed, push_out, [&] { return -contact.separation / substep; });
  const Softness<Real> soft{
      either(closed, spring.bias_rate, [] { return Real(0); }),
      either(closed, spring.mass_scale, [] { return Real(1); }),
      either(closed, spring.impulse_scale, [] { return Real(0); })};
  add_impulse<Real>(
      a, b, contact,
      soft_change<Real>(
          soft, contact.normal_mass, separating_velocity(a, b, contact), bias, contact.impulse));
  add_friction(a, b, contact, elapsed);
}
// [soft_contact]

} // namespace cookbook
