#pragma once

/// \file
/// \brief Which integrator holds in which case of swinging and falling.

#include "05_resolution/integrators/trial/integrators_scenes.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A number for a table: at most so many decimals, and no rounding error in the last digit shown.
inline std::string decimals(double value, int count)
{
  const double scale = std::pow(10, count);
  return number(std::round(value * scale) / scale);
}

/// Whether the oscillator keeps its energy to 1 % over 10 s at 60 Hz.
inline Verdict keeps_energy(const Integrator<double>& method)
{
  const double share = energy_share(oscillating(method, 10, game_rate).back());
  return {std::abs(share - 1) <= 0.01, std::string("energy × ").append(number(share))};
}

/// Whether the oscillator stays within 1,000 times its energy at ω·step = `z`.
inline Verdict stays_bounded(const Integrator<double>& method, double z)
{
  const double most = largest_energy(method, z);
  const bool holds = most <= 1000;
  return {holds, holds ? std::string("energy ≤ × ").append(decimals(most, 0)) : "diverges"};
}

/// Whether 10 s of free fall at 60 Hz are right to 1e-10 m.
inline Verdict falls_right(const Integrator<double>& method)
{
  const double error = fall_error(method, game_rate);
  return {std::abs(error) <= 1e-10, std::string("off by ").append(decimals(error, 8)) + " m"};
}

/// Whether the pendulum keeps time to 0.1 % at 60 Hz.
inline Verdict swings_right(const Integrator<double>& method)
{
  const double period = pendulum_measured(method, game_rate);
  const bool holds = std::abs(period / pendulum().period - 1) <= 0.001;
  return {holds, std::string("period ").append(decimals(period, 3)) + " s"};
}

/// Whether 1 kg on the spring keeps time to 1 %, at the worst of 30, 60 … 960 Hz.
inline Verdict springs_right(const Integrator<Vector3<double>>& method)
{
  double worst = 0;
  for (double rate = 30; rate <= 960; rate *= 2)
  {
    const double period = spring_measured(method, rate);
    worst = std::max(worst, std::abs(period / spring_period(soft_spring, 1.0) - 1));
  }
  return {worst <= 0.01, std::string("off by ").append(decimals(100 * worst, 3)) + " %"};
}

/// One case: the verdict on each integrator.
template <class Place, class Oracle>
VerdictRow case_row(
    const std::string& id, const std::string& what, const std::vector<Integrator<Place>>& methods,
    const Oracle& oracle)
{
  VerdictRow row{id, what, {}};
  for (const Integrator<Place>& method : methods)
  {
    row.verdicts.push_back(oracle(method));
  }
  return row;
}

/// All cases, with the verdict on each integrator.
inline std::vector<VerdictRow> integrator_verdicts()
{
  const auto one = integrators<double>();
  const auto three = integrators<Vector3<double>>();
  const auto limit = [](double z)
  { return [z](const Integrator<double>& method) { return stays_bounded(method, z); }; };
  return {
      case_row("I1", "oscillator of 1 Hz, 10 s at 60 Hz: energy kept to 1 %", one, keeps_energy),
      case_row("I2", "oscillator, ω·step = 1.99: stays bounded", one, limit(1.99)),
      case_row("", "ω·step = 2.01", one, limit(2.01)),
      case_row("", "ω·step = 2.82", one, limit(2.82)),
      case_row("", "ω·step = 2.83", one, limit(2.83)),
      case_row("I3", "free fall, 10 s at 60 Hz: right to 1e-10 m", one, falls_right),
      case_row("I10", "pendulum from 90° at 60 Hz: 2.368 s to 0.1 %", one, swings_right),
      case_row("I11", "mass on a spring, 30 to 960 Hz: 1.987 s to 1 %", three, springs_right)};
}

} // namespace cookbook
