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

constexpr std::size_t random_pairs = 0, resting_pairs = 2; // places in timed_workloads

std::string depth_chart(const std::vector<MeasuredBoxMethod>& methods)
{
  plot::Chart chart(
      "box_chart", "Two boxes: cost against depth error, random pairs in cache",
      {"time [ns a pair]", plot::Scale::log},
      {"error of the depth, 99 % below [1, of the size]", plot::Scale::log});
  chart.describe("Time of each method against the 99th percentile of its depth's error.")
      .name_failures("wrong verdicts");
  return box_chart_svg(chart, methods, depth_error_of, random_pairs);
}

std::string jump_chart(const std::vector<MeasuredBoxMethod>& methods)
{
  plot::Chart chart(
      "box_chart_jumps", "Two boxes: cost against jitter, resting pairs in cache",
      {"time [ns a pair]", plot::Scale::log},
      {"jump of the contact's middle, 99 % below [1, of the size]", plot::Scale::log});
  chart.describe("Time of each method against how far its points jump when a box moves a little.");
  return box_chart_svg(chart, methods, jump_of, resting_pairs);
}

/// Where boxes only touch or not, in cache and from memory.
std::string overlaps_html(const BoxExtent& extent)
{
  std::vector<MeasuredTimes> rows;
  time_overlaps("random", extent.in_cache, extent.cache, rows);
  time_overlaps("resting", extent.in_cache, extent.cache, rows);
  time_overlaps("random", extent.in_memory, extent.memory, rows);
  return box_times_html("overlap only", {"random", "resting", "random, from memory"}, rows);
}

std::string streams_html(const BoxExtent& extent)
{
  std::vector<MeasuredTimes> rows;
  time_streams("random", extent, rows);
  time_streams("resting", extent, rows);
  return box_times_html("from memory", {"random", "resting"}, rows);
}

void run(const Arguments& given)
{
  BoxExtent extent;
  if (given.value("effort") == "quick")
  {
    extent = {2048, 100'000, 1000, {3, 0.002}, {3, 0.002}};
  }
  const std::vector<MeasuredBoxMethod> methods = measured_methods(extent);
  std::vector<MeasuredTimes> times;
  for (const MeasuredBoxMethod& method : methods)
  {
    times.push_back(method.times);
  }
  const auto paragraph = [](const std::string& text) { return "<p>" + text + "</p>\n"; };
  const std::string html =
      box_times_html("in cache", timed_workloads, times) + streams_html(extent) +
      overlaps_html(extent) + peaks_html(extent) + box_errors_html(methods) +
      paragraph(
          "Depths: " +
          box_knee_sentence(methods, depth_error_of, random_pairs, "99 % of its depths within")) +
      paragraph(
          "Jitter: " +
          box_knee_sentence(methods, jump_of, resting_pairs, "99 % of its jumps within")) +
      paragraph(measure::machine_line() + ".");
  save_figure(given, "box_chart.svg", depth_chart(methods));
  save_figure(given, "box_chart_jumps.svg", jump_chart(methods));
  save_figure(given, "box_chart.html", html);
  const std::string steps = steps_html(measured_steps(extent.in_cache, extent.cache));
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
