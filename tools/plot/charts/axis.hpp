#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cookbook::plot
{

/// How an axis spreads its values.
enum class Scale
{
  linear,
  log
};

/// One axis of a chart: its label with its unit ("time [ns]"), its scale, and limits if fixed.
struct Axis
{
  std::string label;
  Scale scale = Scale::linear;
  std::optional<double> min = std::nullopt;
  std::optional<double> max = std::nullopt;
};

/// A labelled mark on an axis; a minor one has no text.
struct Tick
{
  double value;
  std::string text;
};

/// Returns ticks at 1, 2 or 5 times a power of ten within [min, max], about `count` of them.
std::vector<Tick> linear_ticks(double min, double max, int count);

/// Returns ticks at the powers of ten within [min, max] and unlabelled ones between them.
///
/// At most `count` are labelled: 10^{k}, or plain numbers where all lie within 0.01 … 10000.
/// A range with fewer than two powers of ten has labels at 2 and 5 times them too.
std::vector<Tick> log_ticks(double min, double max, int count);

/// Returns `value` with at most `digits` significant digits, without trailing zeros or −0.
std::string significant(double value, int digits);

/// Widens [low, high] to a pleasant range: round ticks if linear, a margin of decades if log.
struct Range
{
  double min;
  double max;
};
Range pleasant_range(double low, double high, Scale scale);

} // namespace cookbook::plot
