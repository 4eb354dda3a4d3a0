#pragma once

/// \file
/// \brief A contact as a damped spring, stepped implicitly, whatever the masses are.

#include <algorithm>
#include <numbers>

namespace cookbook
{

// [softness]
/// A damped spring as a contact uses it, whatever the masses are; R13.
template <class Real>
struct Softness
{
  Real bias_rate;     ///< [1/s], speed of the push out for each metre of depth
  Real mass_scale;    ///< [1], fraction of the rigid impulse that is given
  Real impulse_scale; ///< [1], fraction of the impulse so far that is taken back
};

/// The contact that is no spring: all of the impulse, nothing taken back, no push out.
template <class Real>
constexpr Softness<Real> rigid()
{
  return {Real(0), Real(1), Real(0)};
}

/// The spring of an angular frequency [rad/s] and a damping ratio [1], both zero or more, for a
/// time step [s] above zero; R13.
///
/// A frequency of zero is no spring at all: it gives no impulse.
template <class Real>
constexpr Softness<Real>
softness_of(const Real& angular_frequency, const Real& damping_ratio, const Real& step)
{
  if (angular_frequency == Real(0))
  {
    return {Real(0), Real(0), Real(1)};
  }
  const Real a1 = Real(2) * damping_ratio + step * angular_frequency;
  const Real a2 = step * angular_frequency * a1;
  const Real a3 = Real(1) / (Real(1) + a2);
  return {angular_frequency / a1, a2 * a3, a3};
}

/// The same of a frequency in turns a second [Hz]; R13.
template <class Real>
constexpr Softness<Real> softness(Real frequency, Real damping_ratio, Real step)
{
  const Real turn = Real(2) * std::numbers::pi_v<Real>;
  return softness_of<Real>(turn * frequency, damping_ratio, step);
}
// [softness]

// [soft_change]
/// What a soft contact adds [N s] to its impulse so far, where its surfaces part at a speed [m/s]
/// and are to be pushed apart at another, the bias [m/s]; R14.
///
/// `mass` [kg] is what the push feels, 1/K; zero where nothing can move. The sum never falls below
/// zero: contacts do not pull.
template <class Real>
Real soft_change(
    const Softness<Real>& soft, const Real& mass, const Real& speed, const Real& bias,
    const Real& accumulated)
{
  using std::max;
  const Real residual = mass * soft.mass_scale * (bias - speed);
  return max(Real(-accumulated), Real(residual - soft.impulse_scale * accumulated));
}
// [soft_change]

} // namespace cookbook
