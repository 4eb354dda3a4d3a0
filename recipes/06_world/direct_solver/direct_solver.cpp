/// \file
/// \brief Lets towers stand on exact answers, and compares what bodies carry with statics.

#include "06_world/direct_solver/direct_solver.hpp"
#include "06_world/direct_solver/trial/direct_solver_figures.hpp"
#include "06_world/direct_solver/trial/direct_solver_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

/// A length [m] in nanometres, without what is below a tenth of one.
std::string nanometres(double length)
{
  return number(std::round(length * 1e10) / 10);
}

void run(const Arguments& given)
{
  Table table({"after 3 s", "sinks by [nm]", "drifts by [nm]", "deepest overlap [nm]"});
  for (const std::string& scene : standing_scenes)
  {
    const WorldRun done = run_world(named_scene(scene), {.duration = 3});
    table.row({scene, nanometres(done.sink), nanometres(done.drift), nanometres(done.overlap)});
  }
  std::cout << table.text();
  save_figure(given, "direct_solver.svg", top_chart().svg());
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "direct_solver",
      .summary = "Lets towers stand on exact answers: how far they sink and drift."};
  return run_program(argc, argv, arguments, run);
}
