/// \file
/// \brief Drops a ball by five rules for its bounces, and draws how high it comes and when it
/// rests.

#include "05_resolution/restitution/restitution.hpp"
#include "05_resolution/restitution/trial/restitution_cases.hpp"
#include "05_resolution/restitution/trial/restitution_figures.hpp"
#include "05_resolution/restitution/trial/restitution_scenes.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_drop(const Drop& drop)
{
  const double share = drop.restitution * drop.restitution;
  const bool ends = drop.restitution < 1;
  Table table({"rule", "first apex [m]", "second apex [m]", "energy left", "rests at [s]"});
  const double due = ends ? settling_time(drop.height, drop.gravity, drop.restitution) : 0;
  table.row(
      {"by hand", tidied(share * drop.height), tidied(share * share * drop.height),
       tidied(share * share), ends ? tidied(due) : "never"});
  for (const BounceRule& rule : bounce_rules())
  {
    const std::vector<Flight> rows = flight(drop, rule);
    const std::vector<double> high = apexes(rows, drop.gravity);
    const auto apex = [&](std::size_t i) { return i < high.size() ? tidied(high[i]) : "none"; };
    const double left = high.size() > 1 ? high[1] / drop.height : 0;
    const double last = last_move(rows);
    table.row(
        {rule.name, apex(0), apex(1), tidied(left),
         last < rows.back().time ? tidied(last) : "never"});
  }
  std::cout << table.text();
}

void run(const Arguments& given)
{
  const double height = number_option<double>(given, "height", 0.01, 100);
  const double restitution = number_option<double>(given, "restitution", 0, 1);
  const double rate = number_option<double>(given, "rate", 10, 10000);
  print_drop({height, restitution, 20, 1 / rate});
  save_figure(given, "restitution.svg", heights_figure().svg());
  save_figure(given, "restitution_rest.svg", rest_figure().svg());
  save_figure(given, "restitution_cost.svg", cost_figure().svg());
  save_figure(
      given, "restitution_cases.html",
      verdict_table(
          "A ball that is dropped, at 60 steps a second: which moment's speed is given back.",
          names_of(bounce_rules()), drop_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "restitution",
      .summary = "Drops a ball by five rules for its bounces: how high it comes, when it rests.",
      .options = {
          {"height", "of the drop [m], 0.01 to 100", "1", {}},
          {"restitution", "how much of the speed a bounce gives back, 0 to 1", "0.8", {}},
          {"rate", "steps a second, 10 to 10000", "60", {}}}};
  return run_program(argc, argv, arguments, run);
}
