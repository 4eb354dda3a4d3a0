#pragma once

/// \file
/// \brief A damped spring by two impulses a step, before and after the bodies move: exact in
/// stretch, speed and energy.

#include "05_resolution/integrators/integrators.hpp"
#include "07_constraints/springs/spring_coefficients.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [spring_flow]
/// What a step makes of a spring: stretch' = p x + q v, speed' = r x + s v.
template <class Real>
struct SpringFlow
{
  Real p; ///< [1]
  Real q; ///< [s]
  Real r; ///< [1/s]
  Real s; ///< [1]
};

/// That of the continuous spring of a frequency [Hz] and a damping ratio [1], for a step [s]; R40.
///
/// A spring that would swing by more than half a turn in a step gets just the damping with which it
/// does not. None gains energy. Throws std::invalid_argument as spring_coefficients() does.
template <class Real>
SpringFlow<Real> spring_flow(Real frequency, Real damping_ratio, Real step)
{
  using std::cos, std::exp, std::expm1, std::sin, std::sqrt;
  const Real z = spring_angle(frequency, damping_ratio, step);
  const auto flow = [&](const Real& mean, const Real& sine, const Real& decay) -> SpringFlow<Real> {
    return {mean + decay * sine, step * sine, -z * z / step * sine, mean - decay * sine};
  };
  if (damping_ratio >= Real(1))
  {
    const Real root = sqrt((damping_ratio - Real(1)) * (damping_ratio + Real(1)));
    const Real fast = exp(-z * (damping_ratio + root)), slow = exp(-z / (damping_ratio + root));
    const Real apart = Real(2) * z * root;
    const Real sine = apart == Real(0) ? slow : -slow * expm1(-apart) / apart;
    return flow((slow + fast) / Real(2), sine, damping_ratio * z);
  }
  const auto [decay, angle] = spring_swing(z, damping_ratio, std::numbers::pi_v<Real>);
  const Real shrinks = exp(-decay);
  const Real sine = angle == Real(0) ? Real(1) : sin(angle) / angle;
  return flow(shrinks * cos(angle), shrinks * sine, decay);
}
// [spring_flow]

// [spring_kicks]
/// By how much [m/s] a spring changes its speed before the bodies move, and after it.
template <class Real>
struct SpringKicks
{
  Real before; ///< [m/s]
  Real after;  ///< [m/s]
};

/// Those with which stretch [m] and speed [m/s] become what the flow of a step [s] says; R40.
template <class Real>
SpringKicks<Real>
spring_kicks(const SpringFlow<Real>& flow, const PhasePoint<Real>& from, const Real& step)
{
  const auto [x, v] = from;
  const Real mean_speed = ((flow.p - Real(1)) * x + flow.q * v) / step;
  return {mean_speed - v, flow.r * x + flow.s * v - mean_speed};
}
// [spring_kicks]

} // namespace cookbook
