/// \file
/// \brief Asks for springs of 1 to 30 Hz, and prints what each way to step them gives.

#include "07_constraints/springs/springs.hpp"
#include "07_constraints/springs/trial/spring_measure.hpp"
#include "07_constraints/springs/trial/springs_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace cookbook;

// [print_springs]
void run(const Arguments& given)
{
  std::vector<std::string> header{"asked [Hz], ratio"};
  for (const SpringWay& way : spring_ways())
  {
    header.push_back(way.name);
  }
  Table table(header);
  for (const double frequency : {1, 5, 15, 30})
  {
    for (const double ratio : {0.0, 0.5, 2.0})
    {
      std::vector<std::string> cells{number(frequency) + ", " + number(ratio)};
      for (const SpringWay& way : spring_ways())
      {
        cells.push_back(got(way, {frequency, ratio, 1.0 / 60}));
      }
      table.row(cells);
    }
  }
  std::cout << table.text();
  save_figure(given, "springs.svg", growth_figure().svg());
  save_figure(given, "springs_energy.svg", spring_energy_figure().svg());
}
// [print_springs]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "springs",
      .summary = "Prints the frequency and damping ratio that springs of 1 to 30 Hz get at 60 Hz."};
  return run_program(argc, argv, arguments, run);
}
