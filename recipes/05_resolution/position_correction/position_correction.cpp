/// \file
/// \brief Takes a cube out of the floor in six ways, and draws how it comes out.

#include "05_resolution/position_correction/position_correction.hpp"
#include "05_resolution/position_correction/trial/position_correction_cases.hpp"
#include "05_resolution/position_correction/trial/position_correction_figures.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <algorithm>
#include <iostream>

namespace
{

using namespace cookbook;

void print_recoveries(double depth)
{
  Table table(
      {"a cube in the floor", "fastest [m/s]", "over the floor [m]", "longest jump [m]",
       "out [s]"});
  for (const Correction& way : corrections())
  {
    SunkCube cube;
    cube.bottom = -depth;
    const Recovery found = recovery(run_out(cube, way, 10));
    table.row(
        {way.name, correction_number(found.fastest),
         correction_number(std::max(0.0, found.highest)), correction_number(found.jump),
         correction_number(found.out)});
  }
  std::cout << table.text() << "\n";
}

void print_softness(double frequency)
{
  Table table(
      {"spring of " + number(frequency) + " Hz, ζ = 10", "bias rate [1/s]", "mass scale",
       "impulse scale"});
  for (const double rate : {60, 240, 960})
  {
    const Softness<double> soft = softness(frequency, 10.0, 1 / rate);
    table.row(
        {number(rate) + " steps a second", number(soft.bias_rate), number(soft.mass_scale),
         number(soft.impulse_scale)});
  }
  std::cout << table.text();
}

void run(const Arguments& given)
{
  print_recoveries(number_option<double>(given, "depth", 0, 5));
  print_softness(number_option<double>(given, "frequency", 0.1, 1000));
  save_figure(given, "position_correction.svg", heights_out_figure().svg());
  save_figure(given, "position_correction_depth.svg", depths_figure().svg());
  save_figure(given, "position_correction_hops.svg", hops_figure().svg());
  save_figure(
      given, "position_correction_cases.html",
      verdict_table(
          "A cube of 1 m that starts inside the floor, at 60 frames a second.",
          names_of(corrections()), correction_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "position_correction",
      .summary = "Takes a cube out of the floor in six ways: how fast, how high, how soon.",
      .options = {
          {"depth", "of the cube in the floor [m], 0 to 5", "0.5", {}},
          {"frequency", "of the spring whose numbers are printed [Hz], 0.1 to 1000", "30", {}}}};
  return run_program(argc, argv, arguments, run);
}
