#pragma once

/// \file
/// \brief What a step makes of a spring, measured on the step, and in closed form.

#include "07_constraints/springs/exact_spring.hpp"
#include "07_constraints/springs/spring_ways.hpp"
#include "tools/program/table.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace cookbook
{

/// A spring as it is asked for, and the step [s].
struct SpringAsked
{
  double frequency, damping_ratio, step;
};

/// A way to step a spring: stretch and speed after a step.
struct SpringWay
{
  std::string name;
  std::function<PhasePoint<double>(const PhasePoint<double>&, const SpringAsked&)> step;
};

/// All ways, from the plainest on.
inline std::vector<SpringWay> spring_ways()
{
  using From = const PhasePoint<double>&;
  using Asked = const SpringAsked&;
  const auto by = [](auto coefficients)
  {
    return [coefficients](From from, Asked asked)
    {
      const auto two = coefficients(asked.frequency, asked.damping_ratio, asked.step);
      return spring_step(from, two, asked.step);
    };
  };
  const auto explicit_euler = [](From from, Asked asked)
  { return explicit_spring_step(from, asked.frequency, asked.damping_ratio, asked.step); };
  const auto two_impulses = [](From from, Asked asked) -> PhasePoint<double>
  {
    const SpringFlow<double> flow = spring_flow(asked.frequency, asked.damping_ratio, asked.step);
    const auto [before, after] = spring_kicks(flow, from, asked.step);
    const double speed = from.velocity + before;
    return {from.position + asked.step * speed, speed + after};
  };
  return {
      {"explicit Euler", explicit_euler},
      {"symplectic Euler", by(symplectic_spring<double>)},
      {"implicit Euler", by(implicit_spring<double>)},
      {"one impulse", by(spring_coefficients<double>)},
      {"two impulses", two_impulses}};
}

/// The two factors by which a step multiplies what it is given, as trace and determinant.
struct StepFactors
{
  double trace, determinant;

  /// The larger of both, as an absolute value.
  double growth() const
  {
    const double half = trace / 2, root = half * half - determinant;
    return root > 0 ? std::abs(half) + std::sqrt(root) : std::sqrt(determinant);
  }
};

/// Those of a way, from what it makes of a stretch of one, and of a speed of one.
inline StepFactors factors_of(const SpringWay& way, const SpringAsked& asked)
{
  const double w = 2 * std::numbers::pi * asked.frequency;
  const PhasePoint<double> x = way.step({1, 0}, asked), v = way.step({0, w}, asked);
  const double p = x.position, q = v.position, r = x.velocity / w, s = v.velocity / w;
  return {p + s, p * s - q * r};
}

/// The frequency [Hz] and damping ratio [1] of the continuous spring that has the same factors;
/// none where no such spring is.
inline SpringAsked got_of(const StepFactors& factors, double step)
{
  const double half = factors.trace / 2, root = half * half - factors.determinant;
  double both = std::log(factors.determinant) / 2, swing = 0; // of the two exponents
  double product = 0;
  if (root <= 0)
  {
    swing = std::acos(std::max(-1.0, half / std::sqrt(factors.determinant)));
    product = both * both + swing * swing;
  }
  else
  {
    const double slow = half + std::sqrt(root);
    product = std::log(slow) * std::log(factors.determinant / slow);
  }
  const double z = std::sqrt(product);
  return {z / step / (2 * std::numbers::pi), -both / z, step};
}

/// What a way makes of a spring: "frequency, damping ratio".
inline std::string got(const SpringWay& way, const SpringAsked& asked)
{
  const StepFactors factors = factors_of(way, asked);
  if (factors.growth() > 1 + 1e-9)
  {
    return "explodes";
  }
  const SpringAsked is = got_of(factors, asked.step);
  if (std::isnan(is.frequency)) // one of its factors is negative
  {
    return "flips";
  }
  const auto cut = [](double value) { return number(std::round(1000 * value) / 1000); };
  return cut(is.frequency) + ", " + cut(is.damping_ratio);
}

/// Twice the energy over the mass, in squared speeds.
inline double energy_of(const PhasePoint<double>& at, const SpringAsked& asked)
{
  const double fast = 2 * std::numbers::pi * asked.frequency * at.position;
  return at.velocity * at.velocity + fast * fast;
}

/// By how much an undamped spring grows in a step of ω·step = z, in closed form; R38.
inline double explicit_growth(double z)
{
  return std::sqrt(1 + z * z);
}

/// The same of symplectic Euler; R38.
inline double symplectic_growth(double z)
{
  return z <= 2 ? 1 : z * z / 2 - 1 + z / 2 * std::sqrt(z * z - 4);
}

/// The same of implicit Euler; R38.
inline double implicit_growth(double z)
{
  return 1 / std::sqrt(1 + z * z);
}

/// The same where a spring that would swing by more than an angle [rad] is damped; R39, R40.
inline double exact_growth(double z, double most)
{
  return z <= most ? 1 : std::exp(-std::sqrt(z * z - most * most));
}

} // namespace cookbook
