/// \file
/// \brief Watches motions until a rule takes them for rest, and wakes a tower.

#include "06_world/sleeping/sleeping.hpp"
#include "06_world/sleeping/trial/sleeping_cases.hpp"
#include "06_world/sleeping/trial/sleeping_figures.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

void print_slopes(double speed)
{
  Table table({"ball rolls up", "turns after", "slow", "slow for 0.5 s", "slow, still, steady"});
  for (const double slope : {0.03, 0.1, 0.3, 1.0, 3.0, 10.0})
  {
    const WatchedMotion motion = rolling_up("", "", slope, speed);
    std::vector<std::string> row{number(slope) + "°", seconds(motion.duration / 2)};
    for (const SleepRule& rule : sleep_rules())
    {
      const std::optional<double> asleep = falls_asleep(motion, rule);
      row.push_back(asleep ? seconds(*asleep) : "awake");
    }
    table.row(row);
  }
  std::cout << table.text();
}

void print_bounces()
{
  Table table({"ball", "slow", "slow for 0.5 s", "slow, still, steady"});
  for (const BouncingCase& sphere : bouncing_cases())
  {
    std::vector<std::string> row{sphere.what};
    for (const SleepRule& rule : sleep_rules())
    {
      const std::optional<Bedtime> asleep = bounces_out(sphere.restitution, sphere.threshold, rule);
      row.push_back(asleep ? seconds(asleep->time) : "awake");
    }
    table.row(row);
  }
  std::cout << table.text();
}

void draw(const Arguments& given)
{
  save_figure(given, "sleeping.svg", slope_chart().svg());
  save_figure(given, "sleeping_islands.svg", islands_figure().svg());
  save_figure(
      given, "sleeping_cases.html",
      verdict_table(
          "Balls, watched 60 times a second: when each falls asleep.", names_of(sleep_rules()),
          sleep_verdicts()));
  save_figure(
      given, "sleeping_waking.html",
      verdict_table(
          "A tower asleep loses its lowest cube: what wakes, and when all fall.",
          {"nothing wakes", "neighbours wake", "island wakes"}, waking_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "sleeping",
      .summary = "Watches balls that roll, swing and bounce until a rule puts them to sleep.",
      .options = {{"speed", "of the ball at the foot of the slope [m/s], 0.06 to 10", "0.2", {}}}};
  return run_program(
      argc, argv, arguments,
      [](const Arguments& given)
      {
        print_slopes(number_option(given, "speed", 0.06, 10.0));
        std::cout << "\n";
        print_bounces();
        draw(given);
      });
}
