/// \file
/// \brief Throws a door against its limit under all solvers; draws it, a shoulder, a cart.

#include "07_constraints/joints/joints.hpp"
#include "07_constraints/joints/trial/door.hpp"
#include "07_constraints/joints/trial/joints_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

namespace
{

using namespace cookbook;

/// A number to four decimals.
std::string cut(double value)
{
  return number(std::round(1e4 * value) / 1e4);
}

// [print_doors]
void run(const Arguments& given)
{
  Table table({"solver", "overshoot [deg]", "rebound [rad/s]"});
  for (const std::string solver :
       {"direct", "soft_steps", "wide_steps", "position_based", "sequential_impulses"})
  {
    const DoorEnd end = end_of_door(solver);
    table.row({solver, cut(end.overshoot * 180 / std::numbers::pi), cut(end.rebound)});
  }
  std::cout << table.text();
  save_figure(given, "joints_door.svg", door_figure().svg());
  save_figure(given, "joints_shoulder.svg", shoulder_figure().svg());
  save_figure(given, "joints_kerb.svg", kerb_figure().svg());
}
// [print_doors]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "joints",
      .summary =
          "Throws a door against its limit under all solvers; draws it, a shoulder, a cart."};
  return run_program(argc, argv, arguments, run);
}
