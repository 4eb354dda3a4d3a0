/// \file
/// \brief Holds stacks up by moving bodies: small steps against passes, soft contacts, the table.

#include "06_world/position_based/position_based.hpp"
#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"
#include "06_world/position_based/trial/position_based_figures.hpp"
#include "06_world/position_based/trial/position_based_pitfalls.hpp"
#include "06_world/position_based/trial/position_based_scenes.hpp"
#include "06_world/position_based/trial/solvers_verdicts.hpp"
#include "tools/program/number_option.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

/// A length [m] for a table in millimetres.
std::string millimetres(double length)
{
  return number(std::round(1e7 * length) / 1e4);
}

void print_budgets(int boxes)
{
  const auto column = position_column(std::vector<double>(std::size_t(boxes), 1.0), 0.0);
  Table table({"in a frame", "small steps [mm]", "passes [mm]"});
  for (const int count : {1, 2, 4, 8, 16, 32, 64})
  {
    table.row(
        {std::to_string(count), millimetres(resting_sink(column, count, 1)),
         millimetres(resting_sink(column, 1, count))});
  }
  std::cout << boxes << " rigid boxes: how much too low the top one rests\n" << table.text();
}

void print_world(int cubes)
{
  Table table({"small steps", "sinks [mm]", "by R16 [mm]"});
  const double wanted = 0.5 * cubes * (cubes - 1) * 9.81 / 3600;
  for (const Eigen::Vector2d& sink : sink_by_steps(cubes))
  {
    const double steps = sink.x();
    table.row(
        {number(steps), number(std::round(100 * sink.y()) / 100),
         number(std::round(1e5 * wanted / (steps * steps)) / 100)});
  }
  std::cout << cubes << " cubes in a world after 3 s, by position_based()\n" << table.text();
}

void print_compliance(double compliance)
{
  const std::vector<double> masses{1, 1};
  Table table({"passes", "compliance [mm]", "a fraction of each overlap [mm]"});
  for (const int passes : {1, 4, 16, 64})
  {
    table.row(
        {std::to_string(passes),
         millimetres(resting_sink(position_column(masses, compliance), 4, passes)),
         millimetres(sink_by_share(position_column(masses, 0.0), 0.2, passes))});
  }
  std::cout << "2 soft boxes, 4 small steps a frame; the top one should rest "
            << millimetres(3 * 9.81 * compliance) << " mm lower\n"
            << table.text();
}

void run(const Arguments& given)
{
  const int boxes = number_option(given, "boxes", 1, 50);
  const double compliance = number_option(given, "compliance", 0.0, 0.01);
  print_budgets(boxes);
  std::cout << "\n";
  print_world(5);
  std::cout << "\n";
  print_compliance(compliance);
  save_figure(given, "position_based.svg", budget_figure().svg());
  save_figure(given, "position_based_tower.svg", tower_figure().svg());
  save_figure(
      given, "position_based_cases.html",
      verdict_table(
          "Stacks at 60 frames a second, nothing asleep: impulses, and positions with 1 small step "
          "of 20 passes or 20 of 1.",
          names_of(contact_methods()), stack_verdicts()));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "position_based",
      .summary = "Holds stacks up by moving bodies: small steps against passes, soft contacts.",
      .options = {
          {"boxes", "in a column, 1 to 50", "10", {}},
          {"compliance", "of the soft contacts [m/N], 0 to 0.01", "1e-4", {}}}};
  return run_program(argc, argv, arguments, run);
}
