#pragma once

/// \file
/// \brief What the program of spinning bodies prints: when a body flips, and what it keeps.

#include "05_resolution/spinning_bodies/trial/spinning_bodies_scenes.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_truth.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// A number with four digits, or that there is none.
inline std::string cell(double value)
{
  return std::isfinite(value) ? number(value) : "none";
}

/// The first three flips, and energy and momentum after 10 s, in parts of those at the start.
inline std::string flips_table(const FreeSpin& scene, double rate)
{
  Table table({"10 s", "flip 1 [s]", "flip 2 [s]", "flip 3 [s]", "energy", "momentum"});
  const std::array<double, 3> right = flip_times(scene.moments, scene.spin);
  table.row({"closed form", cell(right[0]), cell(right[1]), cell(right[2]), "1", "1"});
  const double momentum = scene.moments.cwiseProduct(scene.spin).norm();
  for (const SpinMethod& method : spin_methods())
  {
    const SpinRun run = spin_run(scene, method, 10, rate);
    const auto flip = [&](std::size_t i)
    { return i < run.flips.size() ? cell(run.flips[i]) : "–"; };
    const double kept = angular_momentum(run.end, scene.moments).norm() / momentum;
    table.row({method.name, flip(0), flip(1), flip(2), cell(run.energy_ratio), cell(kept)});
  }
  return table.text();
}

/// A drift with two digits' worth of what it says, or that it is no more than rounding.
inline std::string drift(double value)
{
  return value <= 1e-10 ? "rounding" : cell(value);
}

/// The largest drift of energy and of angular momentum on the way, in 100 s.
inline std::string drift_table(const FreeSpin& scene, double rate)
{
  Table table({"100 s", "energy off by", "|L| off by", "L turns by [rad]"});
  for (const SpinMethod& method : spin_methods())
  {
    const SpinRun run = spin_run(scene, method, 100, rate);
    table.row(
        {method.name, drift(run.energy_drift), drift(run.momentum_drift),
         drift(run.momentum_turn)});
  }
  return table.text();
}

} // namespace cookbook
