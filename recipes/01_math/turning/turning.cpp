/// \file
/// \brief Follows a steady spin in several ways, and draws the angle that the simplest loses.

#include "01_math/turning/turning.hpp"
#include "01_math/turning/trial/turning_cases.hpp"
#include "01_math/turning/trial/turning_figures.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// One second at 60 Hz, faster and faster: how far each way is off, and how long its quaternion is.
void print_spins()
{
  Table table({"rad/s about y", "added: off by", "length", "length one: off by", "turned_by"});
  for (const double speed : {0.0, 1.0, 5.0, 10.0, 20.0, 50.0})
  {
    const TurningCase one{"", "", {0, speed, 0}, 60, 60, 1e-6, false};
    const auto ways = spin_ways<double>();
    const auto end = [&](std::size_t way) { return ways[way].turn(one.spin, 1 / one.rate, 60); };
    const auto degrees = [&](std::size_t way)
    {
      const double off = spin_error(one, end(way)) * 180 / std::numbers::pi;
      return number(std::round(off * 1e6) / 1e6) + "°";
    };
    table.row({number(speed), degrees(1), number(end(1).length), degrees(2), degrees(6)});
  }
  std::cout << table.text();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "turning",
      .summary =
          "Follows a steady spin in seven ways, and draws the angle that one of them loses."};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_spins();
        save_figure(given, "turning.svg", tangent_figure().svg());
        save_figure(given, "turning_way.svg", spiral_figure().svg());
        save_figure(
            given, "turning_cases.html",
            verdict_table(
                "Steady spins: the orientation at the end.", names_of(spin_ways<double>()),
                turning_verdicts()));
      });
}
