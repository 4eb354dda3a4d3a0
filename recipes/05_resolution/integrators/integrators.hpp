#pragma once

/// \file
/// \brief Steps through time: six ways to get from position, velocity and acceleration to the next.

namespace cookbook
{

// [phase_point]
/// Where something is and how fast it moves: a number each, or a vector each.
template <class Place>
struct PhasePoint
{
  Place position; ///< [m], or an angle [rad]
  Place velocity; ///< [m/s], or [rad/s]
};

/// How a phase point changes at an instant.
template <class Place>
struct Slope
{
  Place velocity;     ///< [m/s]
  Place acceleration; ///< [m/s²]
};

/// The slope at a point, under an acceleration [m/s²] that is a function of position and velocity.
template <class Place, class Acceleration>
Slope<Place> slope_at(const PhasePoint<Place>& at, const Acceleration& acceleration)
{
  return {at.velocity, acceleration(at.position, at.velocity)};
}

/// A point after a time `step` [s] along a slope that stays the same.
template <class Place, class Real>
PhasePoint<Place>
moved_along(const PhasePoint<Place>& from, const Slope<Place>& slope, const Real& step)
{
  return {from.position + step * slope.velocity, from.velocity + step * slope.acceleration};
}
// [phase_point]

// [euler]
/// One step by explicit Euler: position and velocity along their slope at the start; R21.
///
/// Gains energy wherever anything swings.
template <class Place, class Real, class Acceleration>
PhasePoint<Place>
explicit_euler(const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration)
{
  return moved_along(from, slope_at(from, acceleration), step);
}

/// One step by semi-implicit (symplectic) Euler: the position moves by the new velocity; R20.
///
/// Keeps energy within bounds while ω·step < 2.
template <class Place, class Real, class Acceleration>
PhasePoint<Place>
symplectic_euler(const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration)
{
  const Place a = acceleration(from.position, from.velocity);
  const Place velocity = from.velocity + step * a;
  return {from.position + step * velocity, velocity};
}
// [euler]

// [velocity_verlet]
/// A phase point whose acceleration is known.
template <class Place>
struct VerletPoint
{
  PhasePoint<Place> at; ///< where, and how fast
  Place acceleration;   ///< [m/s²]
};

/// One step by velocity Verlet: the position along a parabola, the velocity by the mean of the
/// accelerations at both ends. Exact in free fall.
///
/// One evaluation; the acceleration it finds serves the next step.
template <class Place, class Real, class Acceleration>
VerletPoint<Place>
velocity_verlet(const VerletPoint<Place>& from, const Real& step, const Acceleration& acceleration)
{
  const Place& a = from.acceleration;
  const Place& v = from.at.velocity;
  const Real half = step / Real(2);
  const Place position = from.at.position + step * (v + half * a);
  const Place next = acceleration(position, v + step * a);
  return {{position, v + half * (a + next)}, next};
}

/// The same where the acceleration at the start is not known: two evaluations.
template <class Place, class Real, class Acceleration>
PhasePoint<Place>
velocity_verlet(const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration)
{
  const Place a = acceleration(from.position, from.velocity);
  return velocity_verlet(VerletPoint<Place>{from, a}, step, acceleration).at;
}
// [velocity_verlet]

// [rk4]
/// One step by the classical Runge–Kutta method of order four: four slopes, weighted; R22.
///
/// Loses energy slowly while ω·step < 2√2.
template <class Place, class Real, class Acceleration>
PhasePoint<Place>
rk4(const PhasePoint<Place>& from, const Real& step, const Acceleration& acceleration)
{
  const Real half = step / Real(2), two(2), six(6);
  const Slope<Place> k1 = slope_at(from, acceleration);
  const Slope<Place> k2 = slope_at(moved_along(from, k1, half), acceleration);
  const Slope<Place> k3 = slope_at(moved_along(from, k2, half), acceleration);
  const Slope<Place> k4 = slope_at(moved_along(from, k3, step), acceleration);
  const Slope<Place> mean{
      (k1.velocity + two * (k2.velocity + k3.velocity) + k4.velocity) / six,
      (k1.acceleration + two * (k2.acceleration + k3.acceleration) + k4.acceleration) / six};
  return moved_along(from, mean, step);
}
// [rk4]

} // namespace cookbook
