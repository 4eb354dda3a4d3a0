/// \file
/// \brief Measures every method for two boxes beside other libraries, and draws cost against error.

#include "04_obb_manifolds/box_chart/trial/box_chart.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_measure.hpp"
#include "04_obb_manifolds/box_chart/trial/box_chart_steps.hpp"
#include "tools/program/program.hpp"

#include <iostream>

namespace
{

using namespace cookbook;

using Points = std::vector<measure::ChartedPoint>;

std::string depth_chart(const Points& points)
{
  plot::Chart chart(
      "box_chart", "Two boxes: cost against depth error, random pairs in cache",
      {"time [ns a pair]", plot::Scale::log},
      {"error of the depth, 99 % below [1, of the size]", plot::Scale::log});
  chart.describe("Time of each method against the 99th percentile of its depth's error.")
      .name_failures("wrong verdicts");
  return box_chart_svg(chart, points);
}

std::string jump_chart(const Points& points)
{
  plot::Chart chart(
      "box_chart_jumps", "Two boxes: cost against jitter, resting pairs in cache",
      {"time [ns a pair]", plot::Scale::log},
      {"jump of the contact's middle, 99 % below [1, of the size]", plot::Scale::log});
  chart.describe("Time of each method against how far its points jump when a box moves a little.");
  return box_chart_svg(chart, points);
}

void run(const Arguments& given)
{
  BoxExtent extent;
  if (given.value("effort") == "quick")
  {
    extent = {2048, 1000, measure::effort_named("quick")};
  }
  const std::vector<MeasuredBoxMethod> methods = measured_methods(extent);
  std::vector<measure::TimingRow> times, overlaps;
  for (const MeasuredBoxMethod& method : methods)
  {
    times.push_back(method.times);
  }
  for (const char* const workload : {"random", "resting"})
  {
    measure::add_column(overlaps, overlap_times(workload, extent));
  }
  constexpr std::size_t resting = 2; // its place in timed_workloads
  const Points depths = box_points(methods, depth_error_of, same_depth);
  const Points jumps = box_points(methods, jump_of, {"box_box_in_registers", "box_pairs"}, resting);
  const auto paragraph = [](const std::string& text) { return "<p>" + text + "</p>\n"; };
  const auto knee = [](const Points& points, const std::string& what)
  { return measure::knee_sentence(points, what, " of the size", 1e-16); };
  const std::string html =
      html_table(measure::times_table("in cache", timed_workloads, times)) +
      html_table(measure::times_table("overlap only", {"random", "resting"}, overlaps)) +
      html_table(peak_table(extent)) + html_table(errors_table(methods)) +
      paragraph("Depths. " + knee(depths, "99 % of its depths within")) +
      paragraph("Jitter. " + knee(jumps, "99 % of its jumps within")) +
      paragraph(measure::machine_line() + ".");
  save_figure(given, "box_chart.svg", depth_chart(depths));
  save_figure(given, "box_chart_jumps.svg", jump_chart(jumps));
  save_figure(given, "box_chart.html", html);
  const std::string steps = html_table(steps_table(measured_steps(extent.in_cache, extent.effort)));
  save_figure(given, "box_chart_steps.html", steps);
  std::cout << html << steps;
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments{
      .name = "box_chart",
      .summary = "Speed against accuracy of every method for two boxes.",
      .options = {effort_option()}};
  return run_program(argc, argv, arguments, run);
}
