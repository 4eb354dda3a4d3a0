/// \file
/// \brief A cable and a chain by augmented vertex block descent, pass by pass, against what is
/// right.

#include "07_constraints/avbd/trial/avbd_scenes.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

// [print_avbd]
void run(const Arguments&)
{
  Table table(
      {"passes", "cable off [mm]", "100 kg sink [mm]", "1,000 kg sink [mm]",
       "tower of 10 sinks [mm]"});
  for (const int passes : {10, 20, 50})
  {
    const AvbdSettings settings{.iterations = passes};
    table.row(
        {std::to_string(passes), rounded(1000 * cable_off(settings)),
         rounded(1000 * chain_sink(100, settings)), rounded(1000 * chain_sink(1000, settings)),
         rounded(1000 * tower_sink(10, settings))});
  }
  std::cout << table.text();
}
// [print_avbd]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "avbd", .summary = "A cable and a chain by augmented vertex block descent."};
  return run_program(argc, argv, arguments, run);
}
