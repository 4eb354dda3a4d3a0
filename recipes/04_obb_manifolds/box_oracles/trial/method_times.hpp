#pragma once

/// \file
/// \brief Times of methods for two boxes, side by side, and the chart of cost against error.

#include "04_obb_manifolds/box_oracles/trial/timed_methods.hpp"
#include "tools/measure/cost_chart.hpp"
#include "tools/measure/times_table.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// What was measured of a method for two boxes.
struct MeasuredBoxMethod
{
  measure::TimingRow times;       ///< on each workload
  BoxAccuracy accuracy;           ///< on the first workload
  RestingSteadiness steadiness{}; ///< of resting contacts
};

/// All of `contenders` on the same pairs, timed in one run. No manifold with fewer points costs
/// less than the one that it is made from.
inline std::vector<measure::Timing> box_times(
    const std::vector<TimedMethod>& contenders, const BoxPairLists& lists,
    const measure::Effort& effort)
{
  std::vector<measure::Timed> timed;
  for (const TimedMethod& each : contenders)
  {
    const double count = static_cast<double>(lists.in_float.size());
    timed.push_back({each.name, each.prepare(lists), count, each.peer});
  }
  return measure::time_interleaved(
      timed, effort,
      {{"contact_reduction, float", "box_box_in_registers, float"},
       {"contact_reduction, double", "box_box_in_registers, double"}});
}

/// What a chart of methods shows upwards: infinite where a method fails.
using BoxErrorOf = std::function<double(const MeasuredBoxMethod&)>;

/// What 99 of a hundred errors of the depth do not exceed [1], of the size.
inline double depth_error_of(const MeasuredBoxMethod& method)
{
  return method.accuracy.fails() ? std::numeric_limits<double>::infinity()
                                 : method.accuracy.depth_p99;
}

/// The jump of resting contacts [1], of the size.
inline double jump_of(const MeasuredBoxMethod& method)
{
  const RestingSteadiness& found = method.steadiness;
  return found.compared > 0 ? found.jump : std::numeric_limits<double>::infinity();
}

/// The look of a method: a colour for each recipe, a marker for each scalar type. box_pairs is
/// box_box.
inline plot::Look box_look(const std::vector<MeasuredBoxMethod>& methods, std::size_t m)
{
  const auto recipe = [&](std::size_t i) { return measure::method_of(methods[i].times[0].name); };
  const std::string type = methods[m].times[0].name.substr(recipe(m).size());
  if (methods[m].times[0].peer)
  {
    return {plot::Ink::muted, plot::Marker::diamond, {}};
  }
  std::size_t colour = 0;
  for (std::size_t i = 1; i <= m; ++i)
  {
    colour += recipe(i) != recipe(i - 1) ? 1 : 0;
  }
  const plot::Marker marker = type == ", float"    ? plot::Marker::circle
                              : type == ", double" ? plot::Marker::square
                                                   : plot::Marker::triangle;
  return {plot::series_ink(recipe(m) == "box_pairs" ? 0 : colour), marker, {}};
}

/// The methods on a workload with an error each. Those in `same` give the same answer by
/// construction.
inline std::vector<measure::ChartedPoint> box_points(
    const std::vector<MeasuredBoxMethod>& methods, const BoxErrorOf& error,
    const std::vector<std::string>& same, std::size_t workload = 0)
{
  std::vector<measure::ChartedPoint> points;
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    const measure::Timing& timing = methods[m].times[workload];
    const bool is_same = std::count(same.begin(), same.end(), measure::method_of(timing.name)) > 0;
    const double off = error(methods[m]);
    points.push_back({timing, {off, off}, box_look(methods, m), is_same ? "box_box" : ""});
  }
  return points;
}

/// Those whose depth is box_box's.
inline const std::vector<std::string> same_depth{
    "box_box_in_registers", "contact_reduction", "feature_memory", "box_pairs"};

/// Fills a chart whose axes stand: a point for each method, its name beside it, and the front.
inline std::string
box_chart_svg(plot::Chart chart, const std::vector<measure::ChartedPoint>& points)
{
  measure::draw_methods(chart, points);
  return chart.note(measure::machine_line()).size(800, 560).svg();
}

} // namespace cookbook
