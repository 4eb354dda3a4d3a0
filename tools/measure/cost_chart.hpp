#pragma once

/// \file
/// \brief A chart of cost against error, measured: what charts of methods have in common.

#include "tools/measure/pareto.hpp"
#include "tools/measure/statistics.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/bar_chart.hpp"
#include "tools/plot/charts/chart.hpp"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace cookbook::measure
{

/// No error is too large.
inline constexpr double any = std::numeric_limits<double>::max();

/// A method to be timed, and how wrong it is.
struct ChartedMethod
{
  Timed timed;            ///< how to run it, and its name on the chart
  ErrorStatistics errors; ///< on the same workload; both alike where there is only one number
};

/// What was measured of a method, and its look on a chart.
struct ChartedPoint
{
  Timing timing;
  ErrorStatistics errors;
  plot::Look look;
  std::string answer = {}; ///< what its answers have in common with others'; empty: as method_of
};

/// The method that a name belongs to: all before its first comma, behind which stands the scalar
/// type or the instruction set.
std::string method_of(const std::string& name);

/// As the Pareto front needs them; infinite errors where a method's largest error is more than
/// `most` or not a number, or where it has no time.
std::vector<CostAndError> costs_and_errors(const std::vector<ChartedPoint>& points, double most);

/// Draws each method at its cost: a mark at its largest error, a whisker down to what 99 of a
/// hundred do not exceed, one to the right to what three of four repetitions do not exceed, and the
/// Pareto front of methods.
///
/// A method whose largest error is more than `most`, or not a number, stands in the row of
/// failures; one without a time is named below the chart. Points with the same answer do not
/// compete: the cheapest stands for all.
void draw_methods(plot::Chart& chart, const std::vector<ChartedPoint>& points, double most = any);

/// The sentence under such a chart: where the knee is, what the cheapest method loses, and what
/// less than half the error costs. `what` is said of an error, `unit` behind it; an error of zero
/// counts as `least`.
std::string knee_sentence(
    const std::vector<ChartedPoint>& points, const std::string& what, const std::string& unit,
    double least, double most = any);

/// Times all methods in one run, and draws them; the first one looks as
/// `plot::series_look(first_look)`.
void add_methods(
    plot::Chart& chart, const std::vector<ChartedMethod>& methods, const Effort& effort,
    double most = any, std::size_t first_look = 0);

/// A bar as long as a time [ns], or none where the machine was busy.
void add_bar(plot::BarChart& chart, const Timing& timing, plot::Ink ink);

} // namespace cookbook::measure
