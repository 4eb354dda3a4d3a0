/// \file
/// \brief Solves the small world's contacts as one system: loads, slopes, and what it costs.

#include "05_resolution/plain_direct/plain_direct.hpp"
#include "05_resolution/plain_direct/trial/plain_direct_figures.hpp"
#include "05_resolution/plain_positions/trial/plain_tables.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;
using namespace cookbook::small_world;
using Springs = step_7::World;
using Direct = plain_direct::World;

void print_scenes()
{
  Table table({"scene", "step 7", "direct", "right"});
  add_tower<Springs, Direct>(table, 10);
  for (const double mass : {100.0, 1000.0, 10000.0, 1000000.0})
  {
    add_load<Springs, Direct>(table, mass);
  }
  add_slopes<Springs, Direct>(table);
  std::cout << table.text();
}

void print_price()
{
  Table table({"cubes in a tower", "contact points", "rows R", "R³ / 6"});
  for (const int cubes : {5, 10, 20, 40})
  {
    Direct world = tower<Direct>(cubes);
    step(world, frame);
    const double rows = 3 * static_cast<double>(world.contacts.size());
    table.row(
        {std::to_string(cubes), std::to_string(world.contacts.size()), number(rows),
         number(rows * rows * rows / 6)});
  }
  std::cout << "\nWhat one factorisation costs, in multiplications:\n" << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  return run_program(
      argc, argv,
      {.name = "plain_direct",
       .summary = "Solves the small world's contacts as one system: loads, slopes, its price."},
      [](const Arguments& given)
      {
        print_scenes();
        print_price();
        save_figure(given, "plain_direct.svg", ton_figure().svg());
      });
}
