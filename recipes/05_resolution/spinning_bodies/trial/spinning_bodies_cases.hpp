#pragma once

/// \file
/// \brief Free spins and turns, and what each way to step them makes of them.

#include "05_resolution/spinning_bodies/trial/spinning_bodies_scenes.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_truth.hpp"
#include "05_resolution/spinning_bodies/trial/steady_spin_cases.hpp"
#include "tools/program/table.hpp"
#include "tools/program/verdicts.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// A free spin, and how well it is to be kept. L may turn by a hundredth of a radian.
struct SpinCase
{
  std::string id; ///< in the book; empty for a neighbour of the case above
  FreeSpin scene;
  double duration;       ///< [s], at 60 Hz
  double energy_limit;   ///< of |E/E₀ − 1|
  double momentum_limit; ///< of ||L|/|L₀| − 1|
  bool flips;            ///< whether the first three flips are to be right, to 2 %
};

/// All cases.
inline std::vector<SpinCase> spin_cases()
{
  const Vector3<double> sword(1, 8e-4, 1.0007), plank(0.04, 1, 1.04), coin(1, 1, 2);
  const Vector3<double> racket = tennis_racket().moments, spin = tennis_racket().spin;
  return {
      {"I4", tennis_racket(), 10, 0.01, 1e-3, true},
      {"", {"the same for 100 s", racket, spin}, 100, 1e-4, 1e-10, true},
      {"",
       {"a sword, moments 1, 0.0008, 1.0007, 10 rad/s", sword, {7, 3, 7}},
       10,
       0.01,
       1e-3,
       false},
      {"",
       {"a plank, moments 0.04, 1, 1.04, 170 rad/s", plank, {20, 140, 100}},
       10,
       0.01,
       1e-3,
       false},
      {"", {"a coin, moments 1, 1, 2, 9 rad/s", coin, {3, 0, 8}}, 10, 1e-9, 1e-9, false},
      {"",
       {"a grain, a plank of 1e-40 kg m², 4e6 rad/s", 1e-40 * plank, {1e6, 2e6, 3e6}},
       10,
       0.1,
       1e-3,
       false}};
}

/// Whether the first three flips come when they should, to 2 %.
inline bool flips_in_time(const FreeSpin& scene, const std::vector<double>& flips)
{
  const std::array<double, 3> right = flip_times(scene.moments, scene.spin);
  bool in_time = flips.size() >= 3;
  for (std::size_t i = 0; in_time && i < 3; ++i)
  {
    in_time = std::abs(flips[i] / right[i] - 1) <= 0.02;
  }
  return in_time;
}

/// What is said of a run: the first thing that is wrong, or how well it keeps the energy.
inline Verdict spin_verdict(const SpinCase& one, const SpinRun& run)
{
  if (!(run.energy_drift <= 1e100))
  {
    return {false, "blows up"};
  }
  if (one.flips && run.flips.empty())
  {
    return {false, "never flips"};
  }
  if (!(run.energy_drift <= one.energy_limit))
  {
    const std::string more = "E off by more than " + number(100 * one.energy_limit) + " %";
    return {false, one.id.empty() ? more : "E × " + number(run.energy_ratio)};
  }
  if (!(run.momentum_drift <= one.momentum_limit))
  {
    return {false, "|L| off by " + rough(run.momentum_drift)};
  }
  if (!(run.momentum_turn <= 0.01))
  {
    return {false, "L turns by " + rough(run.momentum_turn) + " rad"};
  }
  if (one.flips && !flips_in_time(one.scene, run.flips))
  {
    return {false, "flips late"};
  }
  const bool kept = run.energy_drift <= 1e-10;
  return {true, kept ? "E kept" : "E to " + rough(run.energy_drift)};
}

/// The verdicts on free spins.
inline std::vector<VerdictRow> spin_verdicts()
{
  std::vector<VerdictRow> rows;
  for (const SpinCase& one : spin_cases())
  {
    rows.push_back({one.id, one.scene.what, {}});
    for (const SpinMethod& method : spin_methods())
    {
      const SpinRun run = spin_run(one.scene, method, one.duration, 60);
      rows.back().verdicts.push_back(spin_verdict(one, run));
    }
  }
  return rows;
}

} // namespace cookbook
