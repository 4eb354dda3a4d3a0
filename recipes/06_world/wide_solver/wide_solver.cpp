/// \file
/// \brief Solves many contacts at a time in float, and asks what that changes.

#include "06_world/wide_solver/wide_solver.hpp"
#include "06_world/wide_solver/trial/wide_solver_runs.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

// [print_both]
/// A length [m] in millimetres, to a micrometre: what is finer is rounding's.
std::string millimetres(double length)
{
  return number(std::round(length * 1e6) / 1e3);
}

void run(const Arguments& stored)
{
  Table table(
      {"after 5 s of 8 substeps", "one by one: sink [mm]", "overlap [mm]",
       "many at once: sink [mm]", "overlap [mm]"});
  for (const std::string& scene : compared_scenes)
  {
    const auto [one, wide] = two_runs(scene, 8, 5);
    table.row(
        {scene, millimetres(one.sink), millimetres(one.overlap), millimetres(wide.sink),
         millimetres(wide.overlap)});
  }
  std::cout << table.text();
  save_figure(stored, "wide_solver.svg", apart_chart(5).svg());
}
// [print_both]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "wide_solver",
      .summary = "Solves many contacts at a time, in float: what that changes in some scenes."};
  return run_program(argc, argv, arguments, run);
}
