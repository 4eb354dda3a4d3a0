/// \file
/// \brief Times every rung of the ladder of worlds in one run, and draws cost against error.

#include "06_world/ladder_chart/trial/ladder_chart.hpp"
#include "tools/measure/pareto.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/program.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace
{

using namespace cookbook;

/// What was measured of a method in a scene.
struct Measured
{
  double microseconds; ///< a body and step; NaN where the machine was busy
  LadderEnd end;
};

bool falls(const LadderEnd& end)
{
  return end.error > 0.5;
}

std::string error_text(const LadderEnd& end)
{
  return std::isinf(end.error) ? "–" : falls(end) ? "falls" : rounded(1000 * end.error);
}

/// All methods in a scene; infinite where one does not take part.
std::vector<Measured> measured(const LadderScene& scene, int repetitions)
{
  std::vector<LadderMethod> methods = ladder_methods();
  const auto left_out = [&](const LadderMethod& method) { return !takes_part(method, scene); };
  const double endless = std::numeric_limits<double>::infinity();
  std::vector<Measured> all(methods.size(), {endless, {endless, endless}});
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    if (!left_out(methods[i]))
    {
      places.push_back(i);
    }
  }
  std::erase_if(methods, left_out);
  const std::vector<double> seconds = ladder_seconds(methods, scene, repetitions);
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    all[places[i]] = {1e6 * seconds[i], ladder_end(methods[i], scene)};
  }
  return all;
}

/// Of a method: its mean time in all scenes, NaN where any is, and its largest move in those that
/// are to stay where they are.
Measured over_all(
    const std::vector<LadderScene>& scenes, const std::vector<std::vector<Measured>>& all,
    std::size_t method)
{
  Measured sum{0, {0, 0}};
  for (std::size_t i = 0; i < scenes.size(); ++i)
  {
    const Measured& one = all[i][method];
    sum.microseconds += one.microseconds / static_cast<double>(scenes.size());
    sum.end.error = scenes[i].stands ? std::max(sum.end.error, one.end.error) : sum.end.error;
  }
  return sum;
}

/// The chart of all rungs: a line for the steps of the small world that stand, a point for each
/// other method, and the front of them.
std::string
chart_of(const std::vector<LadderScene>& scenes, const std::vector<std::vector<Measured>>& all)
{
  plot::Chart chart(
      "ladder_chart", "", {"time a body and step, mean of four scenes [µs]", plot::Scale::log},
      {"farthest move of what stands [mm]", plot::Scale::log});
  chart.describe("Time of each rung of the ladder against how far it lets a body move.")
      .name_failures("falls")
      .size(480, 420)
      .legend(plot::Legend::below)
      .note(measure::machine_line());
  const std::vector<LadderMethod> methods = ladder_methods();
  std::vector<Eigen::Vector2d> steps, points;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const std::string& name = methods[i].name;
    const auto [time, end] = over_all(scenes, all, i);
    const Eigen::Vector2d at(time, 1000 * end.error);
    if (std::isnan(time))
    {
      chart.leave_out(name, measure::time_text(time));
    }
    else if (std::isinf(time))
    {
      chart.leave_out(name, "run on the tower only");
    }
    else if (falls(end))
    {
      chart.fails(name, time);
    }
    else
    {
      points.push_back(at);
      if (methods[i].of_steps)
      {
        steps.push_back(at);
      }
      else
      {
        chart.point(name, at, plot::series_look(i - 1)); // no cross, the mark of failures
      }
    }
  }
  if (!steps.empty())
  {
    chart.line("small world, steps 3 to 7", steps, {plot::Ink::a, plot::Marker::circle});
  }
  return chart.front(points).svg();
}

/// Times and errors of all methods in all scenes, and what they hold in memory in the last.
Cells price_table(
    const std::vector<LadderScene>& scenes, const std::vector<std::vector<Measured>>& all)
{
  Cells cells{{"rung"}};
  for (const LadderScene& scene : scenes)
  {
    cells[0].push_back(scene.what + " [µs]");
    cells[0].emplace_back(scene.stands ? "moved [mm]" : "deepest [mm]");
  }
  cells[0].emplace_back("bytes a body");
  for (std::size_t i = 0; i < ladder_methods().size(); ++i)
  {
    cells.push_back({ladder_methods()[i].name});
    for (const std::vector<Measured>& scene : all)
    {
      cells.back().push_back(measure::time_text(scene[i].microseconds));
      cells.back().push_back(error_text(scene[i].end));
    }
    cells.back().push_back(rounded(all.back()[i].end.bytes));
  }
  return cells;
}

void run(const Arguments& given)
{
  const int repetitions = given.value("effort") == "quick" ? 1 : 3;
  const std::vector<LadderScene> scenes = ladder_scenes();
  std::vector<std::vector<Measured>> all;
  for (const LadderScene& scene : scenes)
  {
    all.push_back(measured(scene, repetitions));
  }
  const Cells prices = price_table(scenes, all);
  std::cout << text_table(prices);
  save_figure(given, "ladder_chart.html", html_table(prices));
  save_figure(given, "ladder_chart.svg", chart_of(scenes, all));
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "ladder_chart",
      .summary = "Times every rung of the ladder of worlds, and draws cost against error.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
