#pragma once

#include "tools/plot/charts/axis.hpp"
#include "tools/plot/panel.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

/// What charts of every kind share; all rectangles in pixels, y down.
namespace cookbook::plot
{

/// Maps the values of an axis to pixels.
struct AxisMap
{
  Scale scale;
  Range range;
  double first_pixel; ///< of range.min
  double last_pixel;  ///< of range.max

  double operator()(double value) const;
};

/// A text in a row of failures, and the column in which its point stands.
struct FailureSlot
{
  double x;
  int row;      ///< 0 is the lowest
  bool to_left; ///< the text ends at the point instead of beginning there
};

/// Gives each failure a row, so that no text covers another's text, point or stem.
std::vector<FailureSlot> failure_slots(
    const std::vector<std::string>& labels, const std::vector<double>& pixels, double right);

/// Moves texts apart that want the given heights, at least `spacing` apart within [top, bottom].
std::vector<double>
spread(const std::vector<double>& wanted, double spacing, double top, double bottom);

/// Returns the limits of an axis: as fixed, or pleasant around the values (of which, on a
/// logarithmic axis, only positive ones count).
Range axis_range(const Axis& axis, const std::vector<double>& values);

/// Returns about `count` ticks of an axis.
std::vector<Tick> axis_ticks(const Axis& axis, const Range& range, int count);

inline constexpr double failure_row = 18; ///< height of a row of failures
inline constexpr double floor_strip = 26; ///< height of the strip of zeros on a log axis

} // namespace cookbook::plot
