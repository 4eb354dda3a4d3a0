#pragma once

/// \file
/// \brief Ways to damp a fall, and the cases that tell them apart.

#include "05_resolution/damping/damping.hpp"
#include "05_resolution/damping/trial/damping_pitfalls.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cookbook
{

/// One step of a point that falls with an acceleration [m/s²] and is damped at a rate [1/s].
using DampedStep =
    std::function<PhasePoint<double>(const PhasePoint<double>&, double, double, double)>;

/// A way to damp.
struct DampingMethod
{
  std::string name; ///< as on the page
  DampedStep step;  ///< of point, acceleration, rate, step
};

/// The place follows from the mean of the velocities before and after.
template <class Damped>
DampingMethod damping_method(const std::string& name, const Damped& damped)
{
  return {
      name, [damped](const PhasePoint<double>& from, double a, double rate, double step)
      {
        const double velocity = damped(from.velocity, a, rate, step);
        return PhasePoint<double>{from.position + step / 2 * (from.velocity + velocity), velocity};
      }};
}

/// As published: the share that is right at 60 Hz, each step; then small speeds are no speeds.
inline double published_speed(double velocity, double a, double rate, double step)
{
  const double share = damping_factor(rate, 1.0 / 60);
  return snapped(damped_as_published(velocity, a, share, step), 0.001);
}

/// All ways, the exact one last.
inline std::vector<DampingMethod> damping_methods()
{
  return {
      damping_method("as published", published_speed),
      damping_method(
          "1 − c·step", [](double v, double a, double rate, double step)
          { return explicit_damping_factor(rate, step) * (v + step * a); }),
      damping_method(
          "1/(1 + c·step)", [](double v, double a, double rate, double step)
          { return implicit_damping_factor(rate, step) * (v + step * a); }),
      damping_method(
          "exp(−c·step)", [](double v, double a, double rate, double step)
          { return damping_factor(rate, step) * (v + step * a); }),
      damping_method(
          "exp mid-kick", [](double v, double a, double rate, double step)
          { return damped_kick(v, a, damping_factor(rate, step), step); }),
      {"damped_fall", [](const PhasePoint<double>& from, double a, double rate, double step)
       { return damped_fall(from, a, rate, step); }}};
}

/// A motion along one axis.
struct DampedMotion
{
  double velocity;     ///< [m/s], at first
  double acceleration; ///< [m/s²]
  double rate;         ///< [1/s]
  double time;         ///< [s]
};

/// Where a way takes a motion in so many steps a second.
inline PhasePoint<double>
damped_end(const DampingMethod& method, const DampedMotion& motion, double rate)
{
  PhasePoint<double> at{0, motion.velocity};
  const long steps = std::lround(motion.time * rate);
  for (long i = 0; i < steps; ++i)
  {
    at = method.step(at, motion.acceleration, motion.rate, 1 / rate);
  }
  return at;
}

/// The exact speed [m/s] at the end of a motion.
inline double true_speed(const DampedMotion& motion)
{
  const PhasePoint<double> start{0, motion.velocity};
  return damped_fall(start, motion.acceleration, motion.rate, motion.time).velocity;
}

/// The worst error of the speed at 30, 60 and 240 Hz, as a part of the true speed.
inline double worst_speed(const DampingMethod& method, const DampedMotion& motion)
{
  double worst = 0;
  for (const double rate : {30.0, 60.0, 240.0})
  {
    const double speed = damped_end(method, motion, rate).velocity;
    worst = std::max(worst, std::abs(speed / true_speed(motion) - 1));
  }
  return worst;
}

/// The rate [1/s] that leaves 0.98 of a velocity in a step of 1/60 s.
inline double published_rate()
{
  return -60 * std::log(0.98);
}

/// The motions of the cases: a fall, a fall at its final speed, a slide, a hard brake, a short
/// step.
inline const DampedMotion long_fall{0, -9.81, 0.1, 20};
inline const DampedMotion thick_air{0, -9.81, published_rate(), 20};
inline const DampedMotion slide{1, 0, published_rate(), 1};
inline const DampedMotion hard_brake{1, 0, 150, 1};
inline const DampedMotion free_fall{0, -9.81, 0, 10};

} // namespace cookbook
