/// \file
/// \brief Carries columns of spheres by contacts in turn: how many passes they take, with warm
/// starting and without.

#include "05_resolution/contact_constraint/trial/columns.hpp"
#include "05_resolution/contact_constraint/trial/contact_constraint_figures.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <numbers>

namespace
{

using namespace cookbook;

/// A number for a table, with at most four decimals.
std::string tidied(double value)
{
  return number(std::round(value * 1e4) / 1e4);
}

/// By how much the last of some passes makes the error of a column smaller.
std::string error_factor(const std::vector<double>& masses)
{
  const std::vector<double> errors = errors_by_pass(masses, 1e-9, 1000);
  return "× " + tidied(errors.back() / errors[errors.size() - 2]);
}

void print_ratios(double chosen)
{
  Table table({"heavy on light", "error after a pass", "passes to 0.1 %"});
  for (const double ratio : {1.0, 10.0, 100.0, chosen})
  {
    const std::vector<double> masses{1, ratio};
    table.row(
        {number(ratio) + " kg on 1 kg", error_factor(masses),
         std::to_string(passes_needed(masses, 1e-3))});
  }
  std::cout << table.text();
}

void print_columns()
{
  Table table({"equal spheres", "error after a pass", "passes to 1 %"});
  for (const std::size_t count : {2u, 5u, 10u, 20u})
  {
    const std::vector<double> masses(count, 1.0);
    table.row(
        {std::to_string(count), error_factor(masses), std::to_string(passes_needed(masses, 0.01))});
  }
  std::cout << table.text();
}

void print_frames(int count, int passes)
{
  const auto cold = sink_velocities(std::size_t(count), passes, 240, false);
  const auto warm = sink_velocities(std::size_t(count), passes, 240, true);
  Table table({"frame", "without warm starting", "with it"});
  for (const std::size_t frame : {1u, 2u, 5u, 15u, 60u, 240u})
  {
    table.row({std::to_string(frame), tidied(cold[frame - 1]), tidied(warm[frame - 1])});
  }
  std::cout << count << " spheres, " << passes << " passes a frame: the top sinks at [m/s]\n"
            << table.text();
}

void run(const Arguments& given)
{
  const double ratio = number_option(given, "ratio", 0.001, 1000.0);
  const int spheres = number_option(given, "spheres", 1, 50);
  const int passes = number_option(given, "passes", 1, 1000);
  print_ratios(ratio);
  std::cout << "\n";
  print_columns();
  std::cout << "\n";
  print_frames(spheres, passes);
  save_figure(given, "contact_constraint_passes.svg", column_figure().svg());
  save_figure(given, "contact_constraint.svg", passes_figure().svg());
  save_figure(given, "contact_constraint_frames.svg", frames_figure().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "contact_constraint",
      .summary = "Carries columns of spheres by contacts in turn: how many passes they take.",
      .options = {
          {"ratio", "a mass [kg] on 1 kg, 0.001 to 1000", "1000", {}},
          {"spheres", "in a column, 1 to 50", "10", {}},
          {"passes", "in a frame, 1 to 1000", "10", {}}}};
  return run_program(argc, argv, arguments, run);
}
