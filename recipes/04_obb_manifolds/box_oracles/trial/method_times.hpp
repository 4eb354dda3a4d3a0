#pragma once

/// \file
/// \brief Times of methods for two boxes, side by side, and the chart of cost against error.

#include "04_obb_manifolds/box_oracles/trial/timed_methods.hpp"
#include "tools/measure/pareto.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/plot/charts/chart.hpp"
#include "tools/program/table.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace cookbook
{

/// What something costs on several workloads.
struct MeasuredTimes
{
  std::string name;
  bool peer;              ///< whether it is another library's
  std::vector<double> ns; ///< [ns a pair], on each workload
};

/// What was measured of a method for two boxes.
struct MeasuredBoxMethod
{
  MeasuredTimes times;
  BoxAccuracy accuracy;           ///< on the first workload
  RestingSteadiness steadiness{}; ///< of resting contacts
};

/// The times of contenders on the same pairs [ns a pair], all in one run.
inline std::vector<double> box_times(
    const std::vector<TimedMethod>& all, const BoxPairLists& lists, const measure::Effort& effort)
{
  std::vector<measure::Timed> timed;
  for (const TimedMethod& contender : all)
  {
    timed.push_back(
        {contender.name, contender.prepare(lists), static_cast<double>(lists.in_float.size())});
  }
  std::vector<double> ns;
  for (const measure::Timing& timing : measure::time_interleaved(timed, effort))
  {
    ns.push_back(timing.ns);
  }
  return ns;
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

/// Costs on a workload, and errors, as the Pareto front needs them.
inline std::vector<measure::CostAndError> box_costs_and_errors(
    const std::vector<MeasuredBoxMethod>& methods, const BoxErrorOf& error, std::size_t workload)
{
  std::vector<measure::CostAndError> points;
  for (const MeasuredBoxMethod& method : methods)
  {
    points.push_back({method.times.ns[workload], error(method)});
  }
  return points;
}

/// The look of a method: a colour for each recipe, a marker for each number type. box_pairs is
/// box_box.
inline plot::Look box_look(const std::vector<MeasuredBoxMethod>& methods, std::size_t m)
{
  const auto recipe = [&](std::size_t i)
  { return methods[i].times.name.substr(0, methods[i].times.name.find(',')); };
  const std::string type = methods[m].times.name.substr(recipe(m).size());
  if (methods[m].times.peer)
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

/// Fills a chart whose axes stand: a point for each method, its name beside it, and the front.
inline std::string box_chart_svg(
    plot::Chart chart, const std::vector<MeasuredBoxMethod>& methods, const BoxErrorOf& error,
    std::size_t workload = 0)
{
  const auto points = box_costs_and_errors(methods, error, workload);
  for (std::size_t m = 0; m < methods.size(); ++m)
  {
    const MeasuredBoxMethod& method = methods[m];
    std::isfinite(points[m].error)
        ? chart.point(method.times.name, {points[m].cost, points[m].error}, box_look(methods, m))
        : chart.fails(method.times.name, points[m].cost);
  }
  std::vector<Eigen::Vector2d> front;
  for (const std::size_t i : measure::pareto_front(points))
  {
    front.push_back({points[i].cost, points[i].error});
  }
  return chart.front(front).note(measure::machine_line()).size(800, 560).svg();
}

} // namespace cookbook
