#include "tools/plot/charts/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace cookbook::plot
{
namespace
{

constexpr double tolerance = 1e-9; // of a tick's spacing: a limit that is a tick counts

double power_of_ten(int exponent)
{
  return std::pow(10.0, exponent);
}

/// The step 1, 2 or 5 times a power of ten that is nearest above `rough`.
double nice_step(double rough)
{
  const double power = power_of_ten(static_cast<int>(std::floor(std::log10(rough) + tolerance)));
  for (const double factor : {1.0, 2.0, 5.0})
  {
    if (factor * power >= rough * (1 - tolerance))
    {
      return factor * power;
    }
  }
  return 10 * power;
}

std::string log_text(int exponent, bool plain)
{
  return plain ? significant(power_of_ten(exponent), 6)
               : "10^{" + std::string(exponent < 0 ? "−" : "") +
                     std::to_string(std::abs(exponent)) + "}";
}

} // namespace

std::string significant(double value, int digits)
{
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, std::abs(value));
  std::string text(buffer.data());
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos)
  {
    const int power = std::atoi(text.c_str() + exponent + 1);
    const std::string mantissa = text.substr(0, exponent);
    text = (mantissa == "1" ? "" : mantissa + "·") + log_text(power, false);
  }
  return (value < 0 && text != "0" ? "−" : "") + text;
}

std::vector<Tick> linear_ticks(double min, double max, int count)
{
  std::vector<Tick> ticks;
  if (!(max > min) || count < 1)
  {
    return ticks;
  }
  const double step = nice_step((max - min) / count);
  const double last = std::floor(max / step + tolerance);
  for (double k = std::ceil(min / step - tolerance); k <= last; ++k)
  {
    ticks.push_back({k * step, significant(k * step, 6)});
  }
  return ticks;
}

std::vector<Tick> log_ticks(double min, double max, int count)
{
  std::vector<Tick> ticks;
  const int first = static_cast<int>(std::ceil(std::log10(min) - tolerance));
  const int last = static_cast<int>(std::floor(std::log10(max) + tolerance));
  const int decades = std::max(0, last - first + 1);
  const int stride = std::max(1, (decades + count - 1) / std::max(1, count));
  const bool plain = first >= -2 && last <= 4;
  for (int exponent = first - 1; exponent <= last; ++exponent)
  {
    const double power = power_of_ten(exponent);
    if (exponent >= first)
    {
      ticks.push_back({power, exponent % stride == 0 ? log_text(exponent, plain) : ""});
    }
    for (int factor = 2; factor <= 9 && stride == 1; ++factor)
    {
      const double value = factor * power;
      const bool named = decades < 2 && (factor == 2 || factor == 5);
      if (value >= min * (1 - tolerance) && value <= max * (1 + tolerance))
      {
        ticks.push_back({value, named ? significant(value, 3) : ""});
      }
    }
  }
  return ticks;
}

Range pleasant_range(double low, double high, Scale scale)
{
  if (scale == Scale::log)
  {
    const double a = std::log10(low);
    const double b = std::log10(high);
    const double margin = std::max(0.12, 0.06 * (b - a)) + (b - a < 0.5 ? 0.3 : 0);
    return {std::pow(10, a - margin), std::pow(10, b + margin)};
  }
  if (!(high > low))
  {
    const double half = low == 0 ? 1 : 0.1 * std::abs(low);
    return {low - half, low + half};
  }
  // Begin at zero where the values are not far from it.
  const double a = low > 0 && low < 0.5 * high ? 0 : low;
  const double b = high < 0 && high > 0.5 * low ? 0 : high;
  const double step = nice_step((b - a) / 6);
  return {std::floor(a / step + tolerance) * step, std::ceil(b / step - tolerance) * step};
}

} // namespace cookbook::plot
