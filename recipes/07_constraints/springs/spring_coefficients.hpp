#pragma once

/// \file
/// \brief A damped spring as two numbers, by which one velocity update has its exact frequency and
/// damping at any step.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace cookbook
{

// [check_spring]
/// Refuses a number that is no finite one from `least` to `most`, by its name and value.
template <class Real>
void check_spring(const char* member, const Real& value, const Real& least, const Real& most)
{
  if (!(value >= least && value <= most))
  {
    throw std::invalid_argument(
        std::string(member) + " is " + std::to_string(value) + "; it must be from " +
        std::to_string(least) + " to " + std::to_string(most));
  }
}
// [check_spring]

// [spring_coefficients]
/// A damped spring, for one step: the velocity becomes keeps · v + pulls · x, and then the stretch
/// x + step · v.
template <class Real>
struct SpringCoefficients
{
  Real keeps; ///< [1], fraction of the velocity that is kept, 0 to 1
  Real pulls; ///< [1/s], velocity for each metre of stretch, zero or less
};

/// By how much [rad] a spring swings in a step at most; one that would swing further is damped.
template <class Real>
inline constexpr Real most_swing = std::numbers::pi_v<Real> / 2;

/// The coefficients by which a step [s] has the frequency [Hz] and damping ratio [1] of the
/// continuous spring, to rounding; R39.
///
/// A spring that would swing by more than a quarter turn in a step gets just the damping with which
/// it does not; so a stiff one becomes a rigid joint. A frequency of zero is no spring: 1 and 0.
/// Throws std::invalid_argument where the frequency or the damping ratio is not from 0 to 1e9, or
/// the step not from 1e-9 to 1e3.
template <class Real>
SpringCoefficients<Real> spring_coefficients(Real frequency, Real damping_ratio, Real step)
{
  using std::cos, std::exp, std::sin, std::sqrt;
  check_spring("frequency", frequency, Real(0), Real(1e9));
  check_spring("damping_ratio", damping_ratio, Real(0), Real(1e9));
  check_spring("step", step, Real(1e-9), Real(1e3));
  const Real z = Real(2) * std::numbers::pi_v<Real> * frequency * step;
  if (damping_ratio >= Real(1)) // creeps back: two real eigenvalues
  {
    const Real sum = damping_ratio + sqrt((damping_ratio - Real(1)) * (damping_ratio + Real(1)));
    const Real fast = exp(-z * sum), slow = exp(-z / sum);
    return {fast * slow, -(Real(1) - fast) * (Real(1) - slow) / step};
  }
  const Real swing = z * sqrt((Real(1) - damping_ratio) * (Real(1) + damping_ratio));
  const bool resolved = swing <= most_swing<Real>;
  const Real angle = resolved ? swing : most_swing<Real>;
  const Real decay = resolved ? damping_ratio * z : sqrt((z - angle) * (z + angle));
  const Real r = exp(-decay), real = Real(1) - r * cos(angle), imaginary = r * sin(angle);
  return {r * r, -(real * real + imaginary * imaginary) / step};
}
// [spring_coefficients]

// [spring_impulse]
/// The impulse [N s] of a spring in a step, along the direction in which its stretch grows; R39.
///
/// `mass` [kg] is what the impulse feels, 1/K; `stretch` [m] is beyond its rest length, `speed`
/// [m/s] how fast that grows.
template <class Real>
Real spring_impulse(
    const SpringCoefficients<Real>& spring, const Real& mass, const Real& stretch,
    const Real& speed)
{
  return mass * ((spring.keeps - Real(1)) * speed + spring.pulls * stretch);
}
// [spring_impulse]

} // namespace cookbook
