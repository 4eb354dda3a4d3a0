/// \file
/// \brief Swings a point on a rod and a plank on a joint for a minute, and compares period and
/// energy.

#include "07_constraints/first_joint/first_joint.hpp"
#include "07_constraints/first_joint/trial/first_joint_figures.hpp"
#include "07_constraints/first_joint/trial/rod_swings.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

// [print_swings]
void run(const Arguments& given)
{
  Table table(
      {"pendulum from 86°", "steps a second", "period [s]", "off by [1e-6]", "off the joint [mm]",
       "energy left"});
  const auto row = [&](const std::string& name, int rate, const PendulumRun& is)
  {
    const auto cut = [](double value) { return number(std::round(1000 * value) / 1000); };
    const double off = 1e6 * std::abs(is.period / is.right - 1);
    table.row(
        {name, std::to_string(rate), cut(is.period), rounded(off), rounded(1000 * is.apart),
         cut(is.left)});
  };
  for (const RodWay& way : rod_ways())
  {
    row(way.name, 60, rod_swing({.amplitude = 1.5, .rate = 60}, way.rod));
  }
  row(rod_ways().back().name, 240,
      rod_swing({.amplitude = 1.5, .rate = 240}, rod_ways().back().rod));
  row("a plank in the small world", 60, plank_swing({.amplitude = 1.5, .rate = 60}));
  row("a plank in the small world", 240, plank_swing({.amplitude = 1.5, .rate = 240}));
  std::cout << table.text();
  save_figure(given, "first_joint.svg", rod_figure().svg());
  save_figure(given, "first_joint_energy.svg", rod_energy_figure().svg());
}
// [print_swings]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "first_joint",
      .summary = "Swings a point on a rod and a plank on a ball joint for a minute."};
  return run_program(argc, argv, arguments, run);
}
