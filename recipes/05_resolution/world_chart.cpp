/// \file
/// \brief Times every solver beside Bullet, in one run, and draws cost against how far a tower
/// sinks.

#include "05_resolution/world_chart.hpp"
#include "common/measure/timing.hpp"
#include "common/plot/chart.hpp"
#include "common/program/program.hpp"
#include "common/program/table.hpp"

#include <iostream>
#include <map>

namespace
{

using namespace cookbook;

double bullet_seconds(const std::vector<ChartedRun>& runs)
{
  return runs.back().solver.name.empty() ? runs.back().seconds : 0;
}

/// The chart of a scene: a curve for each solver over its substeps.
std::string chart_of(const std::string& scene, const std::vector<ChartedRun>& runs)
{
  plot::Chart chart(
      "world_chart", "A tower of ten after 5 s: cost against how far a body has gone",
      {"time a body and step [µs]", plot::Scale::log}, {"moved by [m]", plot::Scale::log});
  chart.describe("Time of each solver on " + scene + " against how far it let a body go.")
      .rail("falls")
      .note(measure::machine_line());
  std::map<std::string, std::vector<Eigen::Vector2d>> lines;
  std::map<std::string, double> fallen;
  for (const ChartedRun& run : runs)
  {
    const double time = run.seconds * 1e6;
    if (run.moved > 0.5)
    {
      fallen.emplace(run.solver.line, time);
    }
    else
    {
      lines[run.solver.line].emplace_back(time, run.moved);
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

/// Adds the runs of a scene to a table.
void add(Cells& table, const std::string& scene, const std::vector<ChartedRun>& runs)
{
  table.push_back({scene, "time a body and step [µs]", "moved by [mm]", "× Bullet's time"});
  for (const ChartedRun& run : runs)
  {
    table.push_back(charted_row(run, bullet_seconds(runs)));
  }
}

/// Heaps of more and more boxes: does a body cost more in a larger heap?
Cells heaps()
{
  Cells table{{"heap, 1 s", "direct [µs a body and step]", "soft steps, 4"}};
  for (const char* const scene : {"pile_100", "pile_200", "pile_1000", "pile_2000", "pile_4000"})
  {
    const auto runs = charted_runs(
        named_scene(scene), 1, {{"direct", "direct", 0}, {"soft steps", "soft_steps", 4}});
    table.push_back({scene, number(runs[0].seconds * 1e6), number(runs[1].seconds * 1e6)});
  }
  return table;
}

std::string text_of(const Cells& cells)
{
  Table table(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    table.row(cells[i]);
  }
  return table.text() + "\n";
}

// [run]
void run(const Arguments& given)
{
  std::string html;
  const auto show = [&html](const Cells& table)
  {
    std::cout << text_of(table);
    html += html_table(table);
  };
  for (const char* const scene :
       {"tower", "tower_20", "pyramid", "heavy_on_light_100", "heavy_on_light_1000", "plates"})
  {
    const std::vector<ChartedRun> runs = charted_runs(named_scene(scene), 5, charted_solvers());
    Cells table;
    add(table, scene, runs);
    show(table);
    if (std::string(scene) == "tower")
    {
      save_figure(given, "world_chart.svg", chart_of(scene, runs));
    }
  }
  show(heaps());
  save_figure(given, "world_chart.html", html);
}
// [run]

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "world_chart",
      .summary = "Times every solver beside Bullet, and draws cost against how far a tower sinks."};
  return run_program(argc, argv, arguments, run);
}
