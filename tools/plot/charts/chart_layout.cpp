#include "tools/plot/charts/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>

namespace cookbook::plot
{
namespace
{

/// A stretch of a row that is taken.
struct Block
{
  int row;
  double from;
  double to;
};

bool is_free(const std::vector<Block>& blocks, const Block& wanted)
{
  return std::none_of(
      blocks.begin(), blocks.end(),
      [&wanted](const Block& block)
      { return block.row == wanted.row && block.from < wanted.to && wanted.from < block.to; });
}

/// The lowest row in which a text covers nothing, and its stem no text; where there is none,
/// a stem may pass below texts.
int free_row(const std::vector<Block>& texts, const std::vector<Block>& stems, Block text, double x)
{
  for (const int limit : {6, 40})
  {
    bool open_below = true;
    for (text.row = 0; text.row < limit; ++text.row)
    {
      if (is_free(texts, text) && is_free(stems, text) && (open_below || limit > 6))
      {
        return text.row;
      }
      open_below = open_below && is_free(texts, {text.row, x - 2, x + 2});
    }
  }
  return text.row;
}

} // namespace

double AxisMap::operator()(double value) const
{
  const double t = scale == Scale::log
                       ? std::log10(value / range.min) / std::log10(range.max / range.min)
                       : (value - range.min) / (range.max - range.min);
  return first_pixel + t * (last_pixel - first_pixel);
}

std::vector<FailureSlot> failure_slots(
    const std::vector<std::string>& labels, const std::vector<double>& pixels, double right)
{
  std::vector<std::size_t> order(labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // From right to left, so that texts, which run to the right, meet only what is settled.
  std::stable_sort(
      order.begin(), order.end(),
      [&pixels](std::size_t p, std::size_t q)
      { return std::llround(100 * pixels[p]) > std::llround(100 * pixels[q]); });
  std::vector<FailureSlot> slots(labels.size());
  std::vector<Block> texts;
  std::vector<Block> stems;
  for (const double x : pixels)
  {
    stems.push_back({0, x - 6, x + 6});
  }
  for (const std::size_t k : order)
  {
    const double x = pixels[k];
    const double width = text_width(labels[k], small_size) + 14;
    const bool to_left = x + width > right;
    const Block text{0, to_left ? x - width : x + 6.5, to_left ? x - 6.5 : x + width};
    const int row = free_row(texts, stems, text, x);
    slots[k] = {x, row, to_left};
    texts.push_back({row, to_left ? x - width : x, to_left ? x : x + width});
    for (int below = 1; below <= row; ++below)
    {
      stems.push_back({below, x - 2, x + 2});
    }
  }
  return slots;
}

std::vector<double>
spread(const std::vector<double>& wanted, double spacing, double top, double bottom)
{
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(
      order.begin(), order.end(),
      [&wanted](std::size_t p, std::size_t q)
      { return std::llround(100 * wanted[p]) < std::llround(100 * wanted[q]); });
  std::vector<double> heights(wanted);
  // Share what is missing between neighbours out to both, until nothing moves.
  for (int sweep = 0; sweep < 200; ++sweep)
  {
    for (std::size_t k = 0; k + 1 < order.size(); ++k)
    {
      double& upper = heights[order[k]];
      double& lower = heights[order[k + 1]];
      const double missing = std::max(0.0, spacing - (lower - upper));
      upper -= missing / 2;
      lower += missing / 2;
    }
    for (double& height : heights)
    {
      height = std::clamp(height, top, std::max(top, bottom));
    }
  }
  return heights;
}

Range axis_range(const Axis& axis, const std::vector<double>& values)
{
  double low = 0;
  double high = 0;
  bool any = false;
  for (const double value : values)
  {
    if (axis.scale == Scale::linear || value > 0)
    {
      low = any ? std::min(low, value) : value;
      high = any ? std::max(high, value) : value;
      any = true;
    }
  }
  Range range =
      any ? pleasant_range(low, high, axis.scale) : Range{axis.scale == Scale::log ? 0.1 : 0.0, 1};
  range.min = axis.min.value_or(range.min);
  range.max = axis.max.value_or(range.max);
  if (!(range.max > range.min) || (axis.scale == Scale::log && !(range.min > 0)))
  {
    throw std::invalid_argument("plot: axis \"" + axis.label + "\": limits do not make a range");
  }
  return range;
}

std::vector<Tick> axis_ticks(const Axis& axis, const Range& range, int count)
{
  return axis.scale == Scale::log ? log_ticks(range.min, range.max, count)
                                  : linear_ticks(range.min, range.max, count);
}

} // namespace cookbook::plot
