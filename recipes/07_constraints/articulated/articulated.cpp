/// \file
/// \brief Lets trees of links swing: their energy, and the steps that a loaded chain needs.

#include "07_constraints/articulated/articulated.hpp"
#include "07_constraints/articulated/trial/articulated_figures.hpp"
#include "07_constraints/articulated/trial/articulated_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

namespace
{

using namespace cookbook;

// [print_tables]
std::string energy_table()
{
  Table table({"steps a second", "RK4 off by, in 60 s", "semi-implicit off by 0.1 after [s]"});
  for (const int rate : {60, 120, 240, 480})
  {
    const SwingScene scene{{.links = 2}, 1};
    const EnergyKept fine = energy_kept(scene, rk4_step, rate, 60);
    const EnergyKept game = energy_kept(scene, semi_implicit_step, rate, 60);
    table.row({std::to_string(rate), rounded(fine.off), rounded(game.time)});
  }
  return table.text();
}

std::string tension_table()
{
  Table table({"load [kg]", "steps a frame, by R53", "semi-implicit", "RK4, by R53", "RK4"});
  const auto least = [](const HangingChain& chain, TreeStep step)
  {
    int steps = 1;
    while (!hangs_still(chain, step, steps))
    {
      ++steps;
    }
    return std::to_string(steps);
  };
  for (const int load : {0, 100, 1000, 10000})
  {
    const HangingChain chain{.load = static_cast<double>(load)};
    const double needed = steps_needed(chain);
    table.row(
        {std::to_string(load), rounded(needed), least(chain, semi_implicit_step),
         rounded(needed / std::numbers::sqrt2), least(chain, rk4_step)});
  }
  return table.text();
}
// [print_tables]

void run(const Arguments& given)
{
  std::cout << energy_table() << "\n" << tension_table();
  save_figure(given, "articulated_trace.svg", trace_figure().svg());
  save_figure(given, "articulated_swing.svg", swing_figure().svg());
  save_figure(given, "articulated_passes.svg", passes_figure().svg());
  save_figure(given, "articulated_tension.svg", tension_figure().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "articulated",
      .summary =
          "Lets trees of links swing: their energy, and the steps that a loaded chain needs."};
  return run_program(argc, argv, arguments, run);
}
