/// \file
/// \brief Hangs and swings chains, bridges and beams under the direct solver, and prints how far
/// their joints come apart.

#include "07_constraints/taut/taut.hpp"
#include "07_constraints/taut/trial/taut_figures.hpp"
#include "07_constraints/taut/trial/taut_run.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace cookbook;

// [print_taut]
/// A length in mm, to two digits, above 1 µm.
std::string millimetres(double length)
{
  return length < 1e-6 ? "< 0.001" : rounded(1000 * length);
}

/// A row of the table: a chain for 10 s.
void print(Table& table, const std::string& name, const TrialChain& chain)
{
  GameWorld world = world_of(chain);
  const TautRun ran = run_chain(world, 10);
  const bool swings = chain.towards.x() != 0;
  table.row(
      {name, millimetres(ran.gap), swings ? number(std::round(1000 * ran.left) / 1000) : "–"});
}

void run(const Arguments& given)
{
  const Vector2<double> half(std::sqrt(0.5), std::sqrt(0.5)), level(1, 0);
  Table table({"scene", "off by [mm]", "energy left"});
  print(table, "20 links, 1 t hangs", {.load = 1000});
  print(table, "the same, nudged by .5 m/s", {.load = 1000, .nudge = 0.5});
  print(table, "1 t swings from 45°", {.load = 1000, .towards = half});
  print(table, "links of 1 kg and 1 g, nudged", {.light = 0.001, .nudge = 0.5});
  print(table, "1,000 t hangs, nudged", {.load = 1e6, .nudge = 0.5});
  print(table, "1 t falls from 90°", {.load = 1000, .towards = level});
  for (const int substeps : {4, 16})
  {
    const std::string steps = std::to_string(substeps) + " soft steps, 1 t hangs: stretch";
    table.row({steps, millimetres(stretch_of({.load = 1000}, softly(substeps))), "–"});
  }
  const HangingBridge bridge{.load = 50 * 9.81};
  table.row({"bridge of 30 planks, 50 kg: sag", millimetres(bridge_error(bridge)), "–"});
  table.row({"10 welded beams: droop", millimetres(droop_of_beams(10)), "–"});
  std::cout << table.text();
  save_figure(given, "taut.svg", chain_figure().svg());
  save_figure(given, "taut_bridge.svg", bridge_figure().svg());
}
// [print_taut]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "taut",
      .summary =
          "Prints how far joints of taut chains and bridges come apart in the game's world."};
  return run_program(argc, argv, arguments, run);
}
