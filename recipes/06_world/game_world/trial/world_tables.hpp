#pragma once

/// \file
/// \brief What the program of the world prints of a run, and of scenes under all solvers.

#include "06_world/game_world/trial/world_runs.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <string>

namespace cookbook
{

/// A number rounded to a millionth of a unit.
inline std::string to_a_millionth(double value)
{
  return number(std::round(value * 1e6) / 1e6);
}

/// The measures of a run.
inline std::string measures(const WorldRun& run, const RunSettings& settings)
{
  Table table({"measure", settings.solver});
  table.row({"deepest overlap at the end [mm]", to_a_millionth(run.overlap * 1e3)});
  table.row({"deepest overlap ever [mm]", to_a_millionth(run.deepest * 1e3)});
  if (run.joined)
  {
    table.row({"joints open at most [mm]", to_a_millionth(run.joints_open * 1e3)});
    table.row({"joints turned at most [rad]", to_a_millionth(run.joints_turned)});
  }
  table.row({"farthest across gravity [mm]", to_a_millionth(run.drift * 1e3)});
  table.row({"farthest up or down [mm]", to_a_millionth(run.sink * 1e3)});
  table.row({"energy at the start [J]", to_a_millionth(run.energy_start)});
  table.row({"energy at the end [J]", to_a_millionth(run.energy_end)});
  table.row(
      {"most energy above the start [J]", to_a_millionth(run.energy_most - run.energy_start)});
  table.row({"momentum at the end [kg m/s]", to_a_millionth(run.momentum.norm())});
  table.row({"residual at the end [m/s]", to_a_millionth(run.residual)});
  table.row({"bodies asleep", std::to_string(run.asleep)});
  table.row({"time a body and step [µs]", number(run.time * 1e6)});
  table.row({"slowest step, a body [µs]", number(run.longest_step * 1e6)});
  return table.text();
}

} // namespace cookbook
