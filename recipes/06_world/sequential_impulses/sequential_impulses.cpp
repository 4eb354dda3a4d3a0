/// \file
/// \brief Stacks under sequential impulses: with warm starting and without, by the number of
/// passes.

#include "06_world/sequential_impulses/sequential_impulses.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_figures.hpp"
#include "06_world/sequential_impulses/trial/sequential_impulses_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

/// What a stack does in 20 s.
std::string outcome(const Scene& scene, int passes, bool warm_starting)
{
  const StackRun run = run_stack(scene, {.iterations = passes, .warm_starting = warm_starting}, 20);
  return run.fell > 0 ? "falls after " + rounded(run.fell) + " s"
                      : "sinks " + rounded(1000 * run.sink) + " mm";
}

void print_stacks()
{
  Table table({"stack", "warm starting", "8 passes", "20 passes", "40 passes"});
  const auto rows = [&](const std::string& name, const Scene& scene)
  {
    for (const bool warm_starting : {false, true})
    {
      table.row(
          {name, warm_starting ? "yes" : "no", outcome(scene, 8, warm_starting),
           outcome(scene, 20, warm_starting), outcome(scene, 40, warm_starting)});
    }
  };
  rows("5 cubes", scenes::tower(5));
  rows("10 cubes", scenes::tower(10));
  rows("10 kg on 1 kg", scenes::heavy_on_light(10));
  std::cout << table.text();
}

void print_residuals()
{
  Table table({"passes", "5 cubes [m/s]", "10 cubes [m/s]"});
  const std::vector<double> five = residuals(5, 1000), ten = residuals(10, 1000);
  for (const std::size_t passes : {0u, 1u, 10u, 100u, 1000u})
  {
    const auto tidied = [](double value) { return number(std::round(value * 1e4) / 1e4); };
    table.row({std::to_string(passes), tidied(five[passes]), tidied(ten[passes])});
  }
  std::cout << "The residual of towers at rest, without warm starting\n" << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_program(
      argc, argv,
      {.name = "sequential_impulses",
       .summary = "Runs stacks under sequential impulses, by the number of passes."},
      [](const Arguments& given)
      {
        print_stacks();
        std::cout << "\n";
        print_residuals();
        save_figure(given, "sequential_impulses.svg", residual_figure().svg());
      });
}
