/// \file
/// \brief Lets a body spin freely about its middle axis, step by step in nine ways, and draws it.

#include "05_resolution/spinning_bodies/spinning_bodies.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_cases.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_figures.hpp"
#include "05_resolution/spinning_bodies/trial/spinning_bodies_tables.hpp"
#include "05_resolution/spinning_bodies/trial/steady_spin_cases.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void save_tables(const Arguments& given)
{
  save_figure(
      given, "spinning_bodies_cases.html",
      verdict_table(
          "Free spins at 60 Hz. I4: flips within 2 %, energy within 1 %, |L| within 0.1 %; L turns "
          "by no more than 0.01 rad.",
          names_of(spin_methods()), spin_verdicts()));
  save_figure(
      given, "spinning_bodies_turns.html",
      verdict_table(
          "Steady spins: the orientation at the end.",
          {"angles added, as published", "quaternion added", "added, length one", "rotation_by"},
          turn_verdicts()));
}

void run(const Arguments& given)
{
  const double rate = number_option(given, "rate", 10.0, 1000.0);
  FreeSpin scene = tennis_racket();
  scene.spin.y() = number_option(given, "spin", 0.1, 100.0);
  std::cout << flips_table(scene, rate) << "\n" << drift_table(scene, rate);
  save_figure(given, "spinning_bodies.svg", racket_figure().svg());
  save_figure(given, "spinning_bodies_flips.svg", flips_figure(scene, rate).svg());
  save_figure(given, "spinning_bodies_energy.svg", spin_energy_figure().svg());
  save_figure(given, "spinning_bodies_cost.svg", spin_cost_figure().svg());
  save_tables(given);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "spinning_bodies",
      .summary = "Lets a body with moments 1, 2, 3 kg m² spin freely: when it flips, and what of "
                 "its energy and angular momentum each way to step it keeps.",
      .options = {
          {"rate", "steps a second, 10 to 1000", "60", {}},
          {"spin", "about the middle axis [rad/s], 0.1 to 100", "10", {}}}};
  return run_program(argc, argv, arguments, run);
}
