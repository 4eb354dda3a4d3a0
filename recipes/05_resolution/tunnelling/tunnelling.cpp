/// \file
/// \brief Shoots balls at a wall and past it, and boxes at boxes, and counts what goes wrong.

#include "05_resolution/tunnelling/tunnelling.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_box_cases.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_cases.hpp"
#include "05_resolution/tunnelling/trial/tunnelling_figures.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_speeds(double thickness, double radius, double step)
{
  std::cout << "a ball may be pushed out behind the wall from "
            << number(no_push_through_speed(thickness, radius, step)) << " m/s\n"
            << "a ball may jump the wall unseen from "
            << number(no_tunnel_speed(thickness, radius, step)) << " m/s\n";
}

void print_shares(double thickness, double radius, double step)
{
  std::vector<std::string> header{"balls behind the wall"};
  for (const FlightMethod& method : flight_methods())
  {
    header.push_back(method.name);
  }
  Table table(header);
  for (const double speed : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0})
  {
    const Shots shots{wide_wall(thickness), radius, {speed, 0, 0}, 0, 0.5, step};
    std::vector<std::string> row{number(speed) + " m/s"};
    for (const FlightMethod& method : flight_methods())
    {
      row.push_back(percent(share_passed(shots, method)));
    }
    table.row(row);
  }
  std::cout << table.text();
}

void print_boxes()
{
  Table table({"two boxes", "first touch"});
  for (const BoxSweep& sweep : box_sweeps())
  {
    const auto hit = swept_boxes(sweep.a, sweep.b, box_touching);
    table.row({sweep.what, hit ? number(hit->time * sweep.duration) + " s" : "none"});
  }
  std::cout << table.text();
}

void draw(const Arguments& given)
{
  save_figure(given, "tunnelling.svg", wall_figure().svg());
  save_figure(given, "tunnelling_cost.svg", cost_chart().svg());
  save_figure(given, "tunnelling_beside.svg", beside_chart().svg());
  save_figure(
      given, "tunnelling_cases.html",
      verdict_table(
          "100 balls each, at 60 steps a second where nothing else is said.",
          names_of(flight_methods()), flight_verdicts()));
  save_figure(
      given, "tunnelling_boxes.html",
      verdict_table(
          "The first touch of two boxes, to 0.1 ms.", names_of(box_sweep_methods()),
          box_sweep_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "tunnelling",
      .summary = "Shoots balls at a wall: how many come out behind it, method by method.",
      .options = {
          {"radius", "of the ball [m], 0.001 to 10", "0.05", {}},
          {"thickness", "of the wall [m], 0.001 to 10", "0.02", {}},
          {"rate", "steps in a second, 1 to 1000", "60", {}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        const double radius = number_option(given, "radius", 0.001, 10.0);
        const double thickness = number_option(given, "thickness", 0.001, 10.0);
        const double step = 1 / number_option(given, "rate", 1.0, 1000.0);
        print_speeds(thickness, radius, step);
        std::cout << "\n";
        print_shares(thickness, radius, step);
        std::cout << "\n";
        print_boxes();
        draw(given);
      });
}
