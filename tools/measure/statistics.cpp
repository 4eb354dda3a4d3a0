#include "tools/measure/statistics.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace cookbook::measure
{
namespace
{

void require_numbers(const std::vector<double>& values)
{
  if (values.empty())
  {
    throw std::invalid_argument("values must be there, got none");
  }
  if (std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
  {
    throw std::invalid_argument("values must be numbers, got NaN");
  }
}

} // namespace

double percentile(std::vector<double> values, double percent)
{
  require_numbers(values);
  if (!(percent > 0 && percent <= 100))
  {
    throw std::invalid_argument("percent must be in (0, 100], got " + std::to_string(percent));
  }
  const double rank = std::ceil(percent / 100 * static_cast<double>(values.size()));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double median(std::vector<double> values)
{
  require_numbers(values);
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

ErrorStatistics error_statistics(std::vector<double> errors)
{
  for (double& error : errors)
  {
    error = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }
  return {percentile(errors, 99), percentile(errors, 100)};
}

} // namespace cookbook::measure
