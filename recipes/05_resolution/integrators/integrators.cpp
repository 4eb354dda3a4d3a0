/// \file
/// \brief Lets an oscillator, a falling stone and a pendulum move by six integrators.

#include "05_resolution/integrators/integrators.hpp"
#include "05_resolution/integrators/trial/integrators_figures.hpp"
#include "05_resolution/integrators/trial/integrators_published_verdicts.hpp"
#include "05_resolution/integrators/trial/integrators_tables.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void run(const Arguments& given)
{
  const double rate = number_option<double>(given, "rate", 4, 1000);
  std::cout << motions_table(rate) << "\n"
            << needs_table("oscillator", oscillator()) << "\n"
            << needs_table("pendulum", pendulum()) << "\n"
            << needs_table("springy floor", springy_floor());
  save_figure(given, "integrators.svg", phase_figure().svg());
  save_figure(given, "integrators_energy.svg", energy_figure().svg());
  save_figure(given, "integrators_cost.svg", cost_figure().svg());
  save_figure(given, "integrators_kink.svg", kink_figure().svg());
  save_figure(
      given, "integrators_cases.html",
      verdict_table(
          "Things that swing and fall, by six integrators.", names_of(integrators<double>()),
          integrator_verdicts()));
  save_figure(
      given, "integrators_published.html",
      verdict_table(
          "Particle and spring, as published and here.", {"as published", "here"},
          published_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "integrators",
      .summary = "Lets an oscillator, a falling stone and a pendulum move by six integrators: "
                 "energy, errors, cost.",
      .options = {{"rate", "steps a second of the first table, 4 to 1000", "60", {}}}};
  return run_program(argc, argv, arguments, run);
}
