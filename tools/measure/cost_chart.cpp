#include "tools/measure/cost_chart.hpp"

namespace cookbook::measure
{

void add_methods(
    plot::Chart& chart, const std::vector<ChartedMethod>& methods, const Effort& effort,
    double most, std::size_t first_look)
{
  std::vector<Timed> timed;
  for (const ChartedMethod& method : methods)
  {
    timed.push_back(method.timed);
  }
  const std::vector<Timing> timings = time_interleaved(timed, effort);
  std::vector<Eigen::Vector2d> front;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const plot::Look look = plot::series_look(first_look + i);
    const ErrorStatistics& errors = methods[i].errors;
    if (!(errors.maximum <= most))
    {
      chart.fails(timings[i].name, timings[i].ns, look);
      continue;
    }
    chart.whisker(timings[i].name, timings[i].ns, errors.p99, errors.maximum, look);
    front.push_back({timings[i].ns, errors.maximum});
  }
  chart.front(front);
}

} // namespace cookbook::measure
