#pragma once

/// \file
/// \brief A mass on a spring, stepped: the usual ways as two numbers for the velocity, and their
/// growth.

#include "05_resolution/integrators/integrators.hpp"
#include "05_resolution/position_correction/softness.hpp"
#include "07_constraints/springs/spring_coefficients.hpp"

#include <cmath>
#include <numbers>

namespace cookbook
{

// [spring_step]
/// A spring's stretch and speed after a step [s]: the speed first, then the stretch by the new
/// speed.
template <class Real>
PhasePoint<Real>
spring_step(const PhasePoint<Real>& from, const SpringCoefficients<Real>& spring, const Real& step)
{
  const Real speed = spring.keeps * from.velocity + spring.pulls * from.position;
  return {from.position + step * speed, speed};
}
// [spring_step]

// [spring_ways]
/// Symplectic Euler: the force k x + c v of where the mass is; R38. Explodes for a step [s] beyond
/// 2/ω.
template <class Real>
SpringCoefficients<Real> symplectic_spring(Real frequency, Real damping_ratio, Real step)
{
  const Real w = Real(2) * std::numbers::pi_v<Real> * frequency;
  return {Real(1) - Real(2) * damping_ratio * w * step, -w * w * step};
}

/// Implicit Euler: the force of where the mass will be. It is what `softness` gives, R13, and what
/// XPBD's compliance gives, R15. Never explodes, and damps by about ω·step/2 more than asked; R38.
template <class Real>
SpringCoefficients<Real> implicit_spring(Real frequency, Real damping_ratio, Real step)
{
  const Softness<Real> soft = softness(frequency, damping_ratio, step);
  return {soft.impulse_scale, -soft.mass_scale * soft.bias_rate};
}

/// Explicit Euler: the stretch moves by the old speed; R38. An undamped spring explodes at any
/// step [s].
template <class Real>
PhasePoint<Real>
explicit_spring_step(const PhasePoint<Real>& from, Real frequency, Real damping_ratio, Real step)
{
  const auto [keeps, pulls] = symplectic_spring(frequency, damping_ratio, step);
  return {from.position + step * from.velocity, keeps * from.velocity + pulls * from.position};
}
// [spring_ways]

} // namespace cookbook
