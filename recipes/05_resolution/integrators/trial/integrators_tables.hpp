#pragma once

/// \file
/// \brief What the program of the integrators prints: motions and needs.

#include "05_resolution/integrators/trial/integrators_cost_scenes.hpp"
#include "05_resolution/integrators/trial/integrators_verdicts.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace cookbook
{

/// Every integrator on three motions, in so many steps a second.
inline std::string motions_table(double rate)
{
  Table table(
      {number(rate) + " steps a second", "energy after 10 s", "10 s of fall off by [m]",
       "pendulum [s]"});
  for (const Integrator<double>& method : integrators<double>())
  {
    const double period = pendulum_measured(method, rate);
    table.row(
        {method.name, number(energy_share(oscillating(method, 10, rate).back())),
         decimals(fall_error(method, rate), 6), period > 0 ? decimals(period, 3) : "none"});
  }
  table.row({"exact", "1", "0", decimals(pendulum().period, 3)});
  return table.text();
}

/// How many evaluations a period each integrator needs for some errors of a swing.
inline std::string needs_table(const std::string& name, const Swing& swing)
{
  Table table({name + ", for an error of", "0.1", "0.01", "0.001", "0.0001"});
  for (const Integrator<double>& method : integrators<double>())
  {
    const std::vector<measure::CostAndError> all = shorter_steps(swing, method);
    std::vector<std::string> cells{method.name};
    for (const double error : {0.1, 0.01, 0.001, 0.0001})
    {
      const double needed = std::round(evaluations_needed(all, error));
      cells.push_back(needed > 0 ? number(needed) : "more");
    }
    table.row(cells);
  }
  return table.text();
}

} // namespace cookbook
