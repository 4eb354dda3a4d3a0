#pragma once

/// \file
/// \brief Motions whose answer is known: an oscillator, free fall, a pendulum, a mass on a spring.

#include "05_resolution/integrators/trial/integrators_swing_scenes.hpp"
#include "05_resolution/integrators/trial/spring.hpp"

#include <cmath>
#include <vector>

namespace cookbook
{

/// The energy of the oscillator as a part of what it began with.
inline double energy_share(const PhasePoint<double>& at)
{
  const double speed = at.velocity / oscillator().pace;
  return at.position * at.position + speed * speed;
}

/// The oscillator's course over a time [s] in so many steps a second.
inline PhasePath<double> oscillating(const Integrator<double>& method, double time, double rate)
{
  const Swing swing = oscillator();
  const int steps = static_cast<int>(std::lround(time * rate));
  return method.follow(swing.start, 1 / rate, steps, swing.acceleration);
}

/// The largest energy share that the oscillator ever has in 2,000 steps of ω·step = `z`.
inline double largest_energy(const Integrator<double>& method, double z)
{
  const AccelerationAt<double> pull = [](double x, double) { return -x; };
  double most = 0;
  for (const PhasePoint<double>& at : method.follow({1, 0}, z, 2000, pull))
  {
    const double share = at.position * at.position + at.velocity * at.velocity;
    most = share <= most ? most : share; // not a number counts as most
  }
  return most;
}

/// The error [m] after 10 s of free fall from rest, in so many steps a second.
inline double fall_error(const Integrator<double>& method, double rate)
{
  const AccelerationAt<double> gravity = [](double, double) { return -falling; };
  const int steps = static_cast<int>(std::lround(10 * rate));
  return method.follow({0, 0}, 1 / rate, steps, gravity).back().position + falling * 50;
}

/// The mean period [s] of positions a step apart: between the first and the last passage through
/// zero downwards, each found on the straight line between two steps.
///
/// Not a number with fewer than two such passages.
inline double measured_period(const std::vector<double>& positions, double step)
{
  double first = 0, last = 0;
  int passages = 0;
  for (std::size_t i = 1; i < positions.size(); ++i)
  {
    if (positions[i - 1] > 0 && positions[i] <= 0)
    {
      const double part = positions[i - 1] / (positions[i - 1] - positions[i]);
      last = (static_cast<double>(i - 1) + part) * step;
      first = passages == 0 ? last : first;
      ++passages;
    }
  }
  return (last - first) / (passages - 1);
}

/// The period [s] of the pendulum in so many steps a second, over about 12 s.
inline double pendulum_measured(const Integrator<double>& method, double rate)
{
  const Swing swing = pendulum();
  const int steps = static_cast<int>(std::lround(12 * rate));
  std::vector<double> angles;
  for (const PhasePoint<double>& at :
       method.follow(swing.start, 1 / rate, steps, swing.acceleration))
  {
    angles.push_back(at.position);
  }
  return measured_period(angles, 1 / rate);
}

/// 10 N/m, 1 m long at rest.
inline constexpr Spring<double> soft_spring{10, 0, 1};

/// The period [s] of 1 kg on the spring, let go 10 cm too far out, over about 6 s.
inline double spring_measured(const Integrator<Vector3<double>>& method, double rate)
{
  using Vector = Vector3<double>;
  const AccelerationAt<Vector> pull = [](const Vector& arm, const Vector& velocity) -> Vector
  { return spring_force(soft_spring, arm, velocity); };
  const PhasePoint<Vector> start{{1.1, 0, 0}, {0, 0, 0}};
  const int steps = static_cast<int>(std::lround(6 * rate));
  std::vector<double> stretches;
  for (const PhasePoint<Vector>& at : method.follow(start, 1 / rate, steps, pull))
  {
    stretches.push_back(at.position.x() - soft_spring.rest_length);
  }
  return measured_period(stretches, 1 / rate);
}

} // namespace cookbook
