/// \file
/// \brief Slides a block over a floor and down slopes by four rules of friction, and draws its
/// ways.

#include "05_resolution/friction/friction.hpp"
#include "05_resolution/friction/trial/friction_figures.hpp"
#include "05_resolution/friction/trial/friction_verdicts.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_ways(double speed, double friction)
{
  Table table({"a block stops after [m]", "at 0°", "at 15°", "at 30°", "at 45°"});
  const std::string right = friction_number(speed * speed / (2 * friction * 9.81));
  table.row({"by hand", right, right, right, right});
  for (const FrictionRule& rule : friction_rules())
  {
    std::vector<std::string> cells{rule.name};
    for (const double degrees : {0, 15, 30, 45})
    {
      const OneContactScene scene = sliding_block(speed * heading(degrees), friction);
      cells.push_back(friction_number(way(advanced(scene, rule, speed / (friction * 9.81) + 0.5))));
    }
    table.row(cells);
  }
  std::cout << table.text() << "\n";
}

void print_slopes(double friction)
{
  Table table({"a cube slides in 1 s [m]", "at 10°", "at 20°", "at 30°", "at 40°"});
  const std::vector<double> slopes{10, 20, 30, 40};
  std::vector<std::string> cells{"by hand"};
  for (const double slope : slopes)
  {
    const double angle = slope * std::numbers::pi / 180;
    const double pull = std::sin(angle) - friction * std::cos(angle);
    cells.push_back(friction_number(std::max(0.0, 9.81 / 2 * pull)));
  }
  table.row(cells);
  for (const FrictionRule& rule : friction_rules())
  {
    cells = {rule.name};
    for (const double slope : slopes)
    {
      cells.push_back(friction_number(way(advanced(cube_on_slope(friction, slope), rule, 1))));
    }
    table.row(cells);
  }
  std::cout << table.text();
}

void run(const Arguments& given)
{
  const double speed = number_option<double>(given, "speed", 0.1, 20);
  const double friction = number_option<double>(given, "friction", 0.05, 2);
  print_ways(speed, friction);
  print_slopes(friction);
  save_figure(given, "friction.svg", paths_figure().svg());
  save_figure(given, "friction_slopes.svg", slopes_figure().svg());
  save_figure(given, "friction_cuts.svg", cuts_figure().svg());
  save_figure(
      given, "friction_cases.html",
      verdict_table(
          "Slides, slopes and rolls that have closed forms, at 240 steps a second.",
          names_of(friction_rules()), friction_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "friction",
      .summary = "Slides a block over a floor and down slopes by four rules of friction.",
      .options = {
          {"speed", "of the block on the floor [m/s], 0.1 to 20", "5", {}},
          {"friction", "the coefficient, 0.05 to 2", "0.4", {}}}};
  return run_program(argc, argv, arguments, run);
}
