#pragma once

/// \file
/// \brief Which way to damp holds in which case.

#include "05_resolution/damping/trial/damping_cases.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// One case: the verdict on each way.
template <class Oracle>
VerdictRow damping_row(const std::string& id, const std::string& what, const Oracle& oracle)
{
  VerdictRow row{id, what, {}};
  for (const DampingMethod& method : damping_methods())
  {
    row.verdicts.push_back(oracle(method));
  }
  return row;
}

/// All cases, with the verdict on each way.
inline std::vector<VerdictRow> damping_verdicts()
{
  const auto percent = [](const DampedMotion& motion, double tolerance)
  {
    return [&motion, tolerance](const DampingMethod& method) -> Verdict
    {
      const double worst = worst_speed(method, motion);
      const std::string off = number(std::round(worst * 1e5) / 1e3);
      return {worst <= tolerance, std::string("off by ").append(off) + " %"};
    };
  };
  const auto stops = [](const DampingMethod& method) -> Verdict
  {
    const double speed = std::abs(damped_end(method, hard_brake, 60).velocity);
    return {speed <= 1, speed <= 1 ? "stops" : "gets faster and faster"};
  };
  const auto falls = [](const DampingMethod& method) -> Verdict
  {
    const double y = damped_end(method, free_fall, 1e4).position;
    return {std::abs(y + 490.5) <= 0.1, std::string("y = ").append(number(y)) + " m"};
  };
  return {
      damping_row(
          "I5", "fall, 20 s, c = 0.1/s, 30 to 240 Hz: speed to 0.1 %", percent(long_fall, 1e-3)),
      damping_row("X22", "final speed, c = 1.21/s, 30 to 240 Hz: to 1 %", percent(thick_air, 1e-2)),
      damping_row(
          "", "no gravity, 1 s, c = 1.21/s, 30 to 240 Hz: speed to 1 %", percent(slide, 1e-2)),
      damping_row("", "brake, c = 150/s at 60 Hz: stops", stops),
      damping_row("I6", "no damping, 10 s at 10,000 Hz: falls 490.5 m to 0.1", falls)};
}

} // namespace cookbook
