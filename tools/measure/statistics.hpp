#pragma once

/// \file
/// \brief What many numbers come to: median, percentile, maximum.

#include <cmath>
#include <string>
#include <vector>

namespace cookbook::measure
{

/// The smallest of `values` that at least `percent` of a hundred of them do not exceed.
///
/// Percent lies in (0, 100]; there must be at least one value, and none may be NaN: otherwise
/// std::invalid_argument.
double percentile(std::vector<double> values, double percent);

/// The middle value, or the mean of the two middle ones; std::invalid_argument without values.
double median(std::vector<double> values);

/// How wrong a method is on a workload.
struct ErrorStatistics
{
  double p99;     ///< what 99 of a hundred errors do not exceed
  double maximum; ///< the largest
};

/// Both statistics of at least one error; infinity counts as an error, NaN as an infinite one.
ErrorStatistics error_statistics(std::vector<double> errors);

} // namespace cookbook::measure
