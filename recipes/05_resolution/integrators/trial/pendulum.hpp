#pragma once

/// \file
/// \brief A pendulum: its acceleration, and its exact period however far it swings.

#include <cmath>
#include <limits>
#include <numbers>

namespace cookbook
{

// [pendulum]
/// A mass on a rod without mass.
template <class Real>
struct Pendulum
{
  Real gravity; ///< [m/s²], above zero
  Real length;  ///< [m], above zero
};

/// The angular acceleration [rad/s²] at an angle [rad] from hanging straight down.
template <class Real>
Real pendulum_acceleration(const Pendulum<Real>& pendulum, const Real& angle)
{
  using std::sin;
  return -pendulum.gravity / pendulum.length * sin(angle);
}

/// The arithmetic-geometric mean of two numbers, neither below zero; zero if one of them is.
///
/// Arithmetic and geometric mean take the places of the two until they meet; each round doubles
/// the number of right digits.
template <class Real>
Real arithmetic_geometric_mean(Real a, Real b)
{
  using std::abs, std::sqrt;
  if (a == Real(0) || b == Real(0))
  {
    return Real(0);
  }
  while (abs(a - b) > Real(4) * std::numeric_limits<Real>::epsilon() * a)
  {
    const Real mean = (a + b) / Real(2);
    b = sqrt(a * b);
    a = mean;
  }
  return a;
}

/// The period [s] of a pendulum let go at an angle [rad] between 0 and π; R31.
template <class Real>
Real pendulum_period(const Pendulum<Real>& pendulum, const Real& angle)
{
  using std::cos, std::sqrt;
  const Real slow = sqrt(pendulum.gravity / pendulum.length);
  const Real mean = arithmetic_geometric_mean(Real(1), Real(cos(angle / Real(2))));
  return Real(2) * std::numbers::pi_v<Real> / (slow * mean);
}
// [pendulum]

} // namespace cookbook
