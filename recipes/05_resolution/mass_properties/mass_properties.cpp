/// \file
/// \brief Weighs solids, puts an axe together, and draws its centre of mass and principal axes.

#include "05_resolution/mass_properties/mass_properties.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_cases.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_figures.hpp"
#include "05_resolution/mass_properties/trial/mass_properties_tables.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void run(const Arguments& given)
{
  const double mass = number_option(given, "mass", 1e-12, 1e12);
  const double head = number_option(given, "head", 1e-3, 1e3);
  std::cout << solids_table(mass) << "\n" << axe_table();
  save_figure(given, "mass_properties.svg", axe_figure(axe(head)).svg());
  save_figure(given, "mass_properties_simpler.svg", simpler_figure().svg());
  save_figure(
      given, "mass_properties_cases.html",
      verdict_table(
          "Solids put together: the inertia about the common centre of mass, to 1e-12 of its "
          "largest entry.",
          {"moments added up", "parallel axes, diagonal only", "combined"}, inertia_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "mass_properties",
      .summary = "Weighs solids, and finds the centre of mass and the principal axes of an axe.",
      .options = {
          {"mass", "mass of each solid [kg], 1e-12 to 1e12", "1", {}},
          {"head", "mass of the head of the axe that is drawn [kg], 0.001 to 1000", "1.6", {}}}};
  return run_program(argc, argv, arguments, run);
}
