/// \file
/// \brief Moves the small world's bodies by corrected positions: towers, loads and slopes.

#include "05_resolution/plain_positions/plain_positions.hpp"
#include "05_resolution/plain_positions/trial/plain_positions_figures.hpp"
#include "05_resolution/plain_positions/trial/plain_tables.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using namespace cookbook::small_world;

void print_scenes()
{
  using Springs = small_world::World;
  using Positions = plain_positions::World;
  Table table({"scene", "step 7", "corrected positions", "right"});
  for (const int cubes : {5, 7, 10})
  {
    add_tower<Springs, Positions>(table, cubes);
  }
  for (const double mass : {10.0, 100.0, 1000.0})
  {
    add_load<Springs, Positions>(table, mass);
  }
  add_slopes<Springs, Positions>(table);
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_program(
      argc, argv,
      {.name = "plain_positions",
       .summary = "Moves the small world's bodies by corrected positions: towers, loads, slopes."},
      [](const Arguments& given)
      {
        print_scenes();
        save_figure(given, "plain_positions.svg", sinks_figure().svg());
      });
}
