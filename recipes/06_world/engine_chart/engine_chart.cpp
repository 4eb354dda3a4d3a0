/// \file
/// \brief Times scenes as games have them beside Bullet, and draws what a body costs in more and
/// more crowded ones.

#include "06_world/engine_chart/trial/engine_chart.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <iostream>
#include <map>

namespace
{

using namespace cookbook;

/// Every engine's cost of a scene, a row each. A scene of few bodies is repeated more often: its
/// steps are so short that whatever else the machine does would be the dearest of them.
void add_rows(Cells& table, const std::string& name, double duration, bool quick)
{
  const Scene scene = named_scene(name);
  const std::vector<ChartedSolver> all = recommended_engines();
  const int repetitions = quick ? 1 : std::max(2, static_cast<int>(500 / movable_bodies(scene)));
  const std::vector<SceneCost> costs = scene_costs(scene, all, duration, repetitions);
  const SceneCost bullet = all.back().name.empty() ? costs.back() : SceneCost{0, 0, 0};
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const SceneCost& cost = costs[i];
    table.push_back(
        {i == 0 ? name : "", all[i].line, number(cost.mean * 1e6),
         share_of_bullet(cost.mean, bullet.mean), number(cost.settled * 1e6),
         share_of_bullet(cost.settled, bullet.settled), number(cost.worst / cost.mean)});
  }
}

Cells scenes_beside(bool quick)
{
  Cells table{
      {"scene", "engine", "µs a body and step, first 5 s", "× Bullet", "settled", "× Bullet",
       "worst step, × mean"}};
  const std::vector<std::string> all{"tower",     "tower_20",  "pyramid",    "pile_100",
                                     "pile_1000", "pile_4000", "cubes_1000", "wall",
                                     "wall_hit",  "domino_50", "pit",        "swarm_4000"};
  const std::vector<std::string> few{"tower", "wall_hit_5", "pile_40", "pit_40"};
  for (const std::string& scene : quick ? few : all)
  {
    add_rows(table, scene, 10, quick);
  }
  return table;
}

/// What wide steps cost in scenes, by the instruction set.
Cells widths(bool quick)
{
  Cells table{{"µs a body and step, first 5 s"}};
  for (const InstructionSet set : instruction_sets())
  {
    const std::size_t lanes = wide_passes(set).lanes;
    table[0].push_back(name_of(set) + ", " + std::to_string(lanes) + " contacts at a time");
  }
  const std::vector<std::string> all{"tower",     "pyramid", "pile_100",
                                     "pile_1000", "wall",    "domino_50"};
  for (const std::string& scene : quick ? std::vector<std::string>{"tower", "pile_40"} : all)
  {
    table.push_back({scene});
    for (const double cost : width_costs(named_scene(scene), quick ? 1 : 5, 3))
    {
      table.back().push_back(number(cost * 1e6));
    }
  }
  return table;
}

/// What a body costs [µs] over how many there are, by engine.
using Growth = std::map<std::string, std::vector<Eigen::Vector2d>>;

/// What it costs in the last tenth of scenes of one kind; of more than 4,000 bodies, in the
/// recommended engines only.
Growth growth(const std::string& family, const std::vector<int>& counts, double duration)
{
  Growth lines;
  for (const int count : counts)
  {
    const std::vector<ChartedSolver> all = count > 4000 ? recommended_engines() : engines();
    const std::vector<SceneCost> costs =
        scene_costs(named_scene(family + "_" + std::to_string(count)), all, duration, 1);
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      lines[all[i].line].emplace_back(count, costs[i].settled * 1e6);
    }
  }
  return lines;
}

std::string chart_of(const std::string& file, const std::string& what, const Growth& lines)
{
  plot::Chart chart(
      file, "What a body costs in " + what, {"number of bodies", plot::Scale::log},
      {"time a body and step [µs]", plot::Scale::log});
  chart.describe("Time a body and step over the number of bodies in " + what + ".")
      .note(measure::machine_line());
  for (const auto& [name, points] : lines)
  {
    chart.line(name, points);
  }
  return chart.svg();
}

void run(const Arguments& given)
{
  const bool quick = given.value("effort") == "quick";
  const std::vector<int> counts =
      quick ? std::vector{10, 20, 40, 80} : std::vector{100, 250, 1000, 4000, 16000};
  save_figure(
      given, "engine_chart.svg",
      chart_of("engine_chart", "a heap that has fallen", growth("pile", counts, quick ? 1 : 3)));
  save_figure(
      given, "engine_chart_floor.svg",
      chart_of("engine_chart_floor", "a flat crowd", growth("floor", counts, 1)));
  const Cells beside = scenes_beside(quick), by_width = widths(quick);
  std::cout << text_table(beside) << '\n' << text_table(by_width);
  save_figure(given, "engine_chart.html", html_table(beside));
  save_figure(given, "engine_chart_widths.html", html_table(by_width));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "engine_chart",
      .summary = "Times scenes as games have them beside Bullet, and draws how costs grow.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
