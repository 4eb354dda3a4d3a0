#pragma once

/// \file
/// \brief A chart of cost against error, measured: what most charts of methods have in common.

#include "tools/measure/statistics.hpp"
#include "tools/measure/timing.hpp"
#include "tools/plot/charts/chart.hpp"

#include <cstddef>
#include <limits>
#include <vector>

namespace cookbook::measure
{

/// A method to be timed, and how wrong it is.
struct ChartedMethod
{
  Timed timed;            ///< how to run it, and its name on the chart
  ErrorStatistics errors; ///< on the same workload; both alike where there is only one number
};

/// Times all methods in one run, and draws each at its cost: a mark at its largest error, with a
/// whisker to what 99 of a hundred do not exceed, and the Pareto front of all.
///
/// A method whose largest error is more than `most`, or not a number, stands in the row of
/// failures. The first one looks as `plot::series_look(first_look)`.
void add_methods(
    plot::Chart& chart, const std::vector<ChartedMethod>& methods, const Effort& effort,
    double most = std::numeric_limits<double>::max(), std::size_t first_look = 0);

} // namespace cookbook::measure
