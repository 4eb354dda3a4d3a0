/// \file
/// \brief Times every solver beside Bullet, in one run, and draws cost against how far a tower
/// sinks.

#include "06_world/world_chart/trial/world_chart.hpp"
#include "06_world/world_chart/trial/broad_phase_scenes.hpp"
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

double bullet_seconds(const std::vector<ChartedRun>& runs)
{
  return runs.back().solver.name.empty() ? runs.back().seconds : 0;
}

/// What a chart shows beside the cost.
struct ChartedMeasure
{
  std::string file;             ///< without its ending
  std::string title;            ///< behind "cost against"
  std::string axis;             ///< with the unit
  double ChartedEnd::*measured; ///< read from a run
};

const std::vector<ChartedMeasure> charted_measures{
    {"world_chart", "how far a body has gone", "moved by [m]", &ChartedEnd::moved},
    {"world_chart_overlap", "the deepest overlap", "deepest overlap [m]", &ChartedEnd::overlap},
    {"world_chart_loads", "the error of what is carried", "error of a load [1]",
     &ChartedEnd::load_error}};

/// The chart of the tower: a curve for each solver over its substeps.
std::string chart_of(const ChartedMeasure& shown, const std::vector<ChartedRun>& runs)
{
  plot::Chart chart(
      shown.file, "A tower of ten after 5 s: cost against " + shown.title,
      {"time a body and step [µs]", plot::Scale::log}, {shown.axis, plot::Scale::log});
  chart.describe("Time of each solver on a tower of ten cubes against " + shown.title + ".")
      .name_failures("falls")
      .note(measure::machine_line());
  std::map<std::string, std::vector<Eigen::Vector2d>> lines;
  std::map<std::string, double> fallen;
  for (const ChartedRun& run : runs)
  {
    const double time = run.seconds * 1e6;
    if (run.end.moved > 0.5)
    {
      fallen.emplace(run.solver.line, time);
    }
    else
    {
      lines[run.solver.line].emplace_back(time, std::max(1e-16, run.end.*shown.measured));
    }
  }
  for (const auto& [name, points] : lines)
  {
    points.size() > 1 ? chart.line(name, points) : chart.point(name, points.front());
  }
  for (const auto& [name, time] : fallen)
  {
    chart.fails(name, time);
  }
  return chart.svg();
}

/// A scene under all solvers; loads are asked of those in which each body stands on the one before.
struct ChartedScene
{
  std::string name;
  bool tower;
};

const std::vector<ChartedScene> charted_scenes{
    {"tower", true},
    {"tower_20", true},
    {"pyramid", false},
    {"heavy_on_light_100", true},
    {"heavy_on_light_1000", true},
    {"plates", true}};

/// The runs of a scene as a table.
Cells scene_table(const ChartedScene& scene, const std::vector<ChartedRun>& runs)
{
  Cells table{
      {scene.name, "µs a body and step", "moved by [mm]", "overlap [mm]", "error of a load",
       "× Bullet's time"}};
  for (const ChartedRun& run : runs)
  {
    table.push_back(charted_row(run, scene.tower, bullet_seconds(runs)));
  }
  return table;
}

// [crossover]
/// Who may touch, asked of every pair, by a sweep along x and by a tree: a grid, and a tower, which
/// is where a sweep along x sees nothing.
Cells crossover(const measure::Effort& effort)
{
  Cells table{
      {"boxes", "grid: every pair [µs]", "swept", "tree", "tower: every pair", "swept", "tree"}};
  for (const int count : {4, 16, 64, 256, 1024, 4096})
  {
    std::vector<std::string> row{std::to_string(count)};
    for (std::vector<Bounds> bounds : {grid_bounds(count), row_bounds(count, 1)})
    {
      const auto timings = measure::time_interleaved(
          {{"every pair", [&] { measure::keep(every_overlapping_pair(bounds).size()); }, 1},
           {"sweep", [&] { measure::keep(swept_pairs(bounds).size()); }, 1},
           {"tree", [&] { measure::keep(pairs_by_tree(bounds).size()); }, 1}},
          effort);
      for (const auto& timing : timings)
      {
        row.push_back(measure::time_text(timing.ns / 1e3));
      }
    }
    table.push_back(row);
  }
  return table;
}
// [crossover]

void run(const Arguments& given)
{
  const bool quick = given.value("effort") == "quick";
  std::string html;
  const auto show = [&html](const Cells& table)
  {
    std::cout << text_table(table) << "\n";
    html += html_table(table);
  };
  std::vector<ChartedScene> scenes = charted_scenes;
  scenes.resize(quick ? 1 : scenes.size(), scenes.front());
  for (const ChartedScene& scene : scenes)
  {
    const std::vector<ChartedRun> runs =
        charted_runs(named_scene(scene.name), 5, charted_solvers(), quick ? 1 : 3);
    show(scene_table(scene, runs));
    if (scene.name == "tower")
    {
      for (const ChartedMeasure& shown : charted_measures)
      {
        save_figure(given, shown.file + ".svg", chart_of(shown, runs));
      }
    }
  }
  show(crossover(quick ? measure::Effort{3, 0.001} : measure::Effort{11, 0.005}));
  save_figure(given, "world_chart.html", html);
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "world_chart",
      .summary = "Times every solver beside Bullet, and draws cost against how far a tower sinks.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
