/// \file
/// \brief Lets a stone fall through air at several steps a second, damped in several ways.

#include "05_resolution/damping/damping.hpp"
#include "05_resolution/damping/trial/damping_cases.hpp"
#include "05_resolution/damping/trial/damping_figures.hpp"
#include "05_resolution/damping/trial/damping_verdicts.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_fall(const DampedMotion& motion)
{
  Table table({"speed after 20 s [m/s]", "at 30 Hz", "at 60 Hz", "at 240 Hz"});
  for (const DampingMethod& method : damping_methods())
  {
    const auto speed = [&](double rate)
    { return number(std::abs(damped_end(method, motion, rate).velocity)); };
    table.row({method.name, speed(30), speed(60), speed(240)});
  }
  std::cout << table.text();
}

void run(const Arguments& given)
{
  DampedMotion motion = long_fall;
  motion.rate = number_option<double>(given, "damping", 0, 50);
  print_fall(motion);
  save_figure(given, "damping.svg", fall_figure().svg());
  save_figure(given, "damping_factor.svg", factor_figure().svg());
  save_figure(given, "damping_error.svg", error_figure().svg());
  save_figure(
      given, "damping_cases.html",
      verdict_table("Ways to damp a velocity.", names_of(damping_methods()), damping_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "damping",
      .summary = "Lets a stone fall for 20 s, damped in several ways, at 30, 60 and 240 Hz.",
      .options = {{"damping", "the damping rate of the velocity [1/s], 0 to 50", "0.1", {}}}};
  return run_program(argc, argv, arguments, run);
}
