#pragma once

/// \file
/// \brief Numbers of the trial as text, in tables and in CSV.

#include "07_constraints/joint_trial/trial/joint_trial.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// A length [m] in millimetres, or that it fails.
inline std::string millimetres(double length)
{
  const double size = 1000 * std::abs(length);
  return !std::isfinite(size) ? "fails" : size < 1e-3 ? "<0.001" : rounded(size);
}

/// How far [m] a tower sinks, in millimetres with one digit: at ten cubes on each other rounding
/// errors grow, and compilers differ in the second.
inline std::string one_digit(double length)
{
  const double size = 1000 * std::abs(length), unit = size < 10 ? 1 : 10;
  return size < 1e-3 ? "<0.001" : size < 1 ? "<1" : number(unit * std::round(size / unit));
}

/// A fraction that is to be one, or that it fails.
inline std::string kept(double fraction)
{
  return std::isfinite(fraction) ? number(std::round(1000 * fraction) / 1000) : "fails";
}

/// A fraction that is to be zero.
inline std::string lost(double fraction)
{
  return !std::isfinite(fraction) ? "fails" : fraction < 1e-9 ? "<1e-09" : rounded(fraction);
}

// [trial_csv]
/// A row of the trial's CSV.
inline std::string trial_row(
    const JointRun& run, const std::string& scene, const std::string& measure,
    const std::string& value)
{
  return run.method.name + "," + std::to_string(run.count) + "," + run.method.counted + "," +
         scene + "," + measure + "," + value + "\n";
}

/// The columns: method, its count and what that is of, scene, measure with its unit, value.
inline const std::string trial_header = "method,count,of,scene,measure,value\n";
// [trial_csv]

} // namespace cookbook
