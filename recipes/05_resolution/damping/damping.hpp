#pragma once

/// \file
/// \brief Damping of a velocity at a rate: the same motion whatever the step.

#include "05_resolution/integrators/integrators.hpp"
#include "common/math/exponential.hpp"

#include <cmath>

namespace cookbook
{

// [damping]
/// The fraction of a velocity that is left after a time [s], wearing off at a rate [1/s]; R32.
///
/// Both zero or more. Two steps leave what one of their length together leaves.
template <class Real>
Real damping_factor(const Real& rate, const Real& time)
{
  return exponential<Real>(-rate * time);
}

/// The share left after one step of implicit Euler: a division, no exponential.
///
/// Never negative, whatever the step; decays too slowly, by about half of rate·step.
template <class Real>
Real implicit_damping_factor(const Real& rate, const Real& step)
{
  return Real(1) / (Real(1) + rate * step);
}

/// A velocity [m/s] after a step [s] under an acceleration [m/s²], of which half acts before the
/// velocity is damped and half after.
///
/// `factor` is what damping leaves in that step.
template <class Place, class Real>
Place damped_kick(
    const Place& velocity, const Place& acceleration, const Real& factor, const Real& step)
{
  const Place half = step / Real(2) * acceleration;
  return factor * (velocity + half) + half;
}
// [damping]

// [decay]
/// What is left of a velocity of 1 after a time, and what that sums up to.
template <class Real>
struct Decay
{
  Real factor;  ///< [1], e^(−ct)
  Real reach;   ///< [s], its integral over the time: how far 1 m/s comes
  Real falling; ///< [s²], the integral of that: how far 1 m/s² comes
};

/// The integral of (1−t)·e^(−st) over t from 0 to 1, for `s` from 0 to 1, by its power series.
template <class Real>
Real small_decay(const Real& s)
{
  Real sum(0), term = Real(1) / Real(2);
  for (int k = 3; k <= 20; ++k)
  {
    sum += term;
    term *= -s / Real(k);
  }
  return sum;
}

/// The decay over a time [s] at a rate [1/s], both zero or more; rate zero: no decay.
///
/// Written so that no rate divides by zero or subtracts what is nearly equal.
template <class Real>
Decay<Real> decay(const Real& rate, const Real& time)
{
  const Real s = rate * time, factor = damping_factor(rate, time);
  if (s < Real(1))
  {
    const Real ramp = small_decay(s);
    return {factor, time * (Real(1) - s * ramp), time * time * ramp};
  }
  const Real mean = (Real(1) - factor) / s, ramp = (Real(1) - mean) / s;
  return {factor, time * mean, time * time * ramp};
}

/// Where a steady acceleration [m/s²] and damping at a rate [1/s] take a point in a time [s],
/// exactly; R32.
template <class Place, class Real>
PhasePoint<Place> damped_fall(
    const PhasePoint<Place>& from, const Place& acceleration, const Real& rate, const Real& time)
{
  const Decay<Real> left = decay(rate, time);
  return {
      from.position + left.reach * from.velocity + left.falling * acceleration,
      left.factor * from.velocity + left.reach * acceleration};
}
// [decay]

} // namespace cookbook
