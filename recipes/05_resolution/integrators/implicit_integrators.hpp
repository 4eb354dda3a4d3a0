#pragma once

/// \file
/// \brief Steps through time that ask for the acceleration where they arrive: implicit Euler and
/// the implicit midpoint.

#include "05_resolution/integrators/integrators.hpp"

namespace cookbook
{

// [end_acceleration]
/// The inner product of two vectors, or the product of two numbers.
template <class Place>
auto inner(const Place& a, const Place& b)
{
  if constexpr (requires { a.dot(b); })
  {
    return a.dot(b);
  }
  else
  {
    return a * b;
  }
}

/// A guess at an acceleration [m/s²], and what the acceleration there is beyond it.
template <class Place>
struct Guess
{
  Place acceleration; ///< [m/s²]
  Place missing;      ///< [m/s²]
};

/// The guess at which nothing would be missing if it changed evenly from `before` to `now`.
template <class Place>
Place secant(const Guess<Place>& before, const Guess<Place>& now)
{
  using Real = decltype(inner(now.missing, now.missing));
  const Place moved = now.acceleration - before.acceleration;
  const Place change = now.missing - before.missing;
  const Real length = inner(change, change);
  const Real share = length == Real(0) ? Real(0) : Real(inner(now.missing, change) / length);
  return now.acceleration + now.missing - share * (moved + change);
}

/// The acceleration [m/s²] at the end of a step that moves by the velocity it ends with.
///
/// It stands on both sides of its equation and is found by secant steps. `evaluations`, at least 1,
/// is what that costs: 2 are exact where one number swings on a linear spring, more may help where
/// forces are strong and not linear, and nothing is promised for those if ω·step is well above 2.
template <class Place, class Real, class Acceleration>
Place end_acceleration(
    const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration,
    int evaluations)
{
  const auto guess = [&](const Place& a) -> Guess<Place>
  {
    const Place velocity = from.velocity + step * a;
    const Place there = acceleration(from.position + step * velocity, velocity);
    return {a, there - a};
  };
  Guess<Place> before = guess(Real(0) * from.velocity);
  Place best = before.acceleration + before.missing;
  for (int done = 1; done < evaluations; ++done)
  {
    const Guess<Place> now = guess(best);
    best = secant(before, now);
    before = now;
  }
  return best;
}
// [end_acceleration]

// [implicit]
/// One step by implicit Euler: position and velocity along their slope at the end.
///
/// Never grows, whatever the step, and loses energy wherever anything swings; R21 with a sign.
template <class Place, class Real, class Acceleration>
PhasePoint<Place> implicit_euler(
    const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration,
    int evaluations = 2)
{
  const Place a = end_acceleration(from, step, acceleration, evaluations);
  const Place velocity = from.velocity + step * a;
  return {from.position + step * velocity, velocity};
}

/// One step by the implicit midpoint: along the slope half-way between start and end.
///
/// Keeps the energy of a linear spring exactly, whatever the step.
template <class Place, class Real, class Acceleration>
PhasePoint<Place> implicit_midpoint(
    const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration,
    int evaluations = 2)
{
  const Real half = step / Real(2);
  const Place a = end_acceleration(from, half, acceleration, evaluations);
  const Place velocity = from.velocity + step * a;
  return {from.position + half * (from.velocity + velocity), velocity};
}
// [implicit]

} // namespace cookbook
