/// \file
/// \brief Lets towers stand on soft contacts, and asks how far they sink.

#include "06_world/soft_steps/soft_steps.hpp"
#include "06_world/soft_steps/trial/corner_spin.hpp"
#include "06_world/soft_steps/trial/soft_steps_figures.hpp"
#include "06_world/soft_steps/trial/tall_towers.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <cmath>
#include <iostream>

namespace
{

using namespace cookbook;

// [print_sinks]
void print_sinks(const Arguments& given)
{
  std::vector<std::string> header{"sink [mm] after 5 s"};
  std::vector<std::vector<Sink>> all;
  for (const std::string& scene : sinking_scenes)
  {
    header.push_back(scene);
    all.push_back(sinks(scene));
  }
  Table table(header);
  for (std::size_t i = 0; i < all[0].size(); ++i)
  {
    std::vector<std::string> row{std::to_string(all[0][i].substeps).append(" substeps")};
    for (const std::vector<Sink>& of_scene : all)
    {
      row.push_back(number(std::round(of_scene[i].down * 1e6) / 1e3));
    }
    table.row(row);
  }
  std::cout << table.text();
  save_figure(given, "soft_steps_frame.svg", frame_figure().svg());
  save_figure(given, "soft_steps.svg", sink_chart(all).svg());
}
// [print_sinks]

void print_towers(const Arguments& given)
{
  const std::vector<int> all_substeps{2, 4, 8};
  std::vector<std::vector<Leaning>> all;
  Table table({"towers", "springs [Hz]", "(R35) [cubes]", "upright after 20 s [cubes]"});
  for (const int substeps : all_substeps)
  {
    all.push_back(leaning_towers(substeps));
    table.row(
        {std::to_string(substeps).append(" substeps"), number(frequency_under(substeps)),
         number(std::round(tallest_under(substeps) * 10) / 10),
         std::to_string(highest_upright(all.back()))});
  }
  std::cout << "\n" << table.text();
  save_figure(given, "tall_towers_joint.svg", joint_figure().svg());
  save_figure(given, "tall_towers.svg", lean_chart(all_substeps, all).svg());
}

// [print_kept]
void print_kept(const Arguments& given)
{
  Table table({"aside after 20 s [m]", "arms turn", "arms are kept"});
  for (const std::string scene : {"tower_14", "tower_20", "tower_30", "tower_shifted_20"})
  {
    const auto aside = [&](double anchor_lag)
    {
      const double way = lean(named_scene(scene), {.substeps = 4, .anchor_lag = anchor_lag});
      return way > 1 ? "falls" : number(std::round(way * 100) / 100);
    };
    table.row({scene, aside(0), aside(SoftSettings{}.anchor_lag)});
  }
  std::cout << "\n" << table.text();
  save_figure(given, "lagged_arms.svg", lever_figure().svg());
}
// [print_kept]

// [print_corners]
void print_corners()
{
  Table table({"a corner's radius [arms]", "rests after [s]", "by the moment it bears [s]"});
  for (const double worn : {0.001, 0.002, 0.004})
  {
    const auto seconds = [](double time) { return number(std::round(time * 100) / 100); };
    const WorldSolver solver = soft_solver({.substeps = 4, .torsional_radius = worn});
    table.row(
        {number(worn), seconds(rests_after(cube_on_corner(), solver)),
         seconds(rests_by_formula(worn))});
  }
  std::cout << "\n" << table.text();
}
// [print_corners]

void run(const Arguments& given)
{
  print_sinks(given);
  print_towers(given);
  print_kept(given);
  print_corners();
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "soft_steps",
      .summary = "Lets towers stand on soft contacts: how far they sink, over the substeps, and "
                 "how high they may be."};
  return run_program(argc, argv, arguments, run);
}
