#pragma once

/// \file
/// \brief A damped spring as two numbers, by which one velocity update has its exact frequency and
/// damping at any step.

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

/// The angle [rad], ω times the step [s], of a spring of a frequency [Hz]; refuses what no spring
/// has.
template <class Real>
Real spring_angle(const Real& frequency, const Real& damping_ratio, const Real& step)
{
  check_spring("frequency", frequency, Real(0), Real(1e9));
  check_spring("damping_ratio", damping_ratio, Real(0), Real(1e9));
  check_spring("step", step, Real(1e-9), Real(1e3));
  return Real(2) * std::numbers::pi_v<Real> * frequency * step;
}
// [check_spring]

// [spring_coefficients]
/// A damped spring, for one step: its speed becomes keeps · v + pulls · x, and then its stretch
/// x + step · v.
template <class Real>
struct SpringCoefficients
{
  Real keeps; ///< [1], fraction of the speed that is kept, 0 to 1
  Real pulls; ///< [1/s], speed for each metre of stretch, zero or less
};

/// What a step makes of a spring that swings: a factor exp(−decay ± i angle).
template <class Real>
struct SpringSwing
{
  Real decay; ///< [1]
  Real angle; ///< [rad]
};

/// That of a spring with ω·step = z and a damping ratio below 1, swinging by at most an angle [rad]
/// in a step: one that would swing further gets just the damping with which it does not.
template <class Real>
SpringSwing<Real> spring_swing(const Real& z, const Real& damping_ratio, const Real& most)
{
  using std::sqrt;
  const Real angle = z * sqrt((Real(1) - damping_ratio) * (Real(1) + damping_ratio));
  if (angle <= most)
  {
    return {damping_ratio * z, angle};
  }
  return {sqrt((z - most) * (z + most)), most};
}

/// The coefficients with which a step [s] has the frequency [Hz] and the damping ratio [1] of the
/// continuous spring; R39.
///
/// Right to rounding where the spring swings by at most a quarter turn in a step; one that would
/// swing further is damped until it does not, so that a very stiff one is a rigid joint. A
/// frequency of zero is no spring: 1 and 0. Throws std::invalid_argument where the frequency or the
/// damping ratio is not from 0 to 1e9, or the step not from 1e-9 to 1e3.
template <class Real>
SpringCoefficients<Real> spring_coefficients(Real frequency, Real damping_ratio, Real step)
{
  using std::cos, std::exp, std::sin, std::sqrt;
  const Real z = spring_angle(frequency, damping_ratio, step);
  if (damping_ratio >= Real(1)) // creeps back: two real factors
  {
    const Real sum = damping_ratio + sqrt((damping_ratio - Real(1)) * (damping_ratio + Real(1)));
    const Real fast = exp(-z * sum), slow = exp(-z / sum);
    return {fast * slow, -(Real(1) - fast) * (Real(1) - slow) / step};
  }
  const auto [decay, angle] = spring_swing(z, damping_ratio, std::numbers::pi_v<Real> / 2);
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
