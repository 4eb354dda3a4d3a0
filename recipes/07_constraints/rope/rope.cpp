/// \file
/// \brief A cable, a swing and a load by four methods: errors, energy, stretch, work.

#include "07_constraints/rope/rope.hpp"
#include "07_constraints/rope/trial/rope_figures.hpp"
#include "07_constraints/rope/trial/rope_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

/// A length [m] in millimetres; 0 where it is less than a ten-thousandth of one.
std::string millimetres(double length)
{
  return std::abs(length) < 1e-7 ? "0" : rounded(1000 * std::abs(length));
}

/// A fraction of the energy; a rope with twice as much as at the start has exploded.
std::string fraction(double energy)
{
  return energy < 2 ? number(std::round(1000 * energy) / 1000) : "explodes";
}

/// The name of a method, with the stiffness of its springs.
std::string name_of(const RopeMethod& method)
{
  const bool springs = method.compliance > 0;
  return method.name + (springs ? ", " + number(1 / method.compliance) + " N/m" : "");
}

// [print_methods]
void print_methods()
{
  const double right_angle = std::numbers::pi / 2;
  Table table(
      {"method", "substeps", "iterations", "passes", "sag off by [mm]", "energy left, 45°", "90°",
       "1 t: too long by [mm]"});
  for (const RopeMethod& method :
       {xpbd(1, 1), xpbd(1, 10), xpbd(1, 100), xpbd(10, 1), xpbd(100, 1), implicit_euler_of(1e4),
        implicit_euler_of(1e6), direct_current(1, 2), direct_current(4, 2), direct_previous(1, 2),
        direct_previous(4, 2), direct_previous(10, 2)})
  {
    table.row(
        {name_of(method), std::to_string(method.substeps), std::to_string(method.iterations),
         std::to_string(method.passes()), millimetres(sag_error(method)),
         fraction(swing_energies(method, right_angle / 2, 600).back()),
         fraction(swing_energies(method, right_angle, 600).back()),
         millimetres(stretch_under(method, 1000))});
  }
  std::cout << table.text();
}
// [print_methods]

void run(const Arguments& given)
{
  print_methods();
  save_figure(given, "rope.svg", cable_figure().svg());
  save_figure(given, "rope_error.svg", error_chart().svg());
  save_figure(given, "rope_swing.svg", swing_figure().svg());
  save_figure(given, "rope_energy.svg", energy_chart().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "rope", .summary = "A cable, a swing and a load by four methods."};
  return run_program(argc, argv, arguments, run);
}
