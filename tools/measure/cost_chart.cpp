#include "tools/measure/cost_chart.hpp"

#include "tools/program/table.hpp"

#include <cmath>

namespace cookbook::measure
{

std::string method_of(const std::string& name)
{
  return name.substr(0, name.find(','));
}

std::vector<CostAndError> costs_and_errors(const std::vector<ChartedPoint>& points, double most)
{
  std::vector<CostAndError> all;
  for (const auto& [timing, errors, look, answer] : points)
  {
    const bool counts = errors.maximum <= most && !std::isnan(timing.ns);
    all.push_back(
        {timing.ns, counts ? errors.maximum : std::numeric_limits<double>::infinity(),
         answer.empty() ? method_of(timing.name) : answer});
  }
  return all;
}

void draw_methods(plot::Chart& chart, const std::vector<ChartedPoint>& points, double most)
{
  for (const auto& [timing, errors, look, answer] : points)
  {
    if (std::isnan(timing.ns))
    {
      chart.leave_out(timing.name, time_text(timing.ns));
    }
    else if (!(errors.maximum <= most))
    {
      chart.fails(timing.name, timing.ns, look);
    }
    else
    {
      chart.line(
          "", {{timing.ns, errors.maximum}, {timing.usual, errors.maximum}},
          {look.ink, plot::Marker::none, plot::Stroke::solid});
      chart.whisker(timing.name, timing.ns, errors.p99, errors.maximum, look);
    }
  }
  const std::vector<CostAndError> all = costs_and_errors(points, most);
  std::vector<Eigen::Vector2d> front;
  for (const std::size_t i : pareto_front(all))
  {
    front.push_back({all[i].cost, all[i].error});
  }
  chart.front(front);
}

std::string knee_sentence(
    const std::vector<ChartedPoint>& points, const std::string& what, const std::string& unit,
    double least, double most)
{
  const std::vector<CostAndError> all = costs_and_errors(points, most);
  const std::vector<std::size_t> front = pareto_front(all);
  if (front.empty())
  {
    return "The machine was busy.";
  }
  const std::size_t best = knee(all, front, least);
  const auto said = [&](std::size_t i)
  {
    return points[i].timing.name + ", at " + rounded(all[i].cost) + " ns a pair, has " + what +
           " " + rounded(all[i].error) + unit;
  };
  std::string sentence = "The knee: " + said(best) + ".";
  if (front.front() != best)
  {
    sentence += " The cheapest: " + said(front.front()) + ".";
  }
  if (all[front.back()].error < all[best].error / 2)
  {
    sentence += " The finest: " + said(front.back()) + ".";
  }
  return sentence;
}

void add_methods(
    plot::Chart& chart, const std::vector<ChartedMethod>& methods, const Effort& effort,
    double most, std::size_t first_look)
{
  std::vector<Timed> timed;
  for (const ChartedMethod& method : methods)
  {
    timed.push_back(method.timed);
  }
  std::vector<ChartedPoint> points;
  for (const Timing& timing : time_interleaved(timed, effort))
  {
    const std::size_t i = points.size();
    points.push_back({timing, methods[i].errors, plot::series_look(first_look + i)});
  }
  draw_methods(chart, points, most);
}

void add_bar(plot::BarChart& chart, const Timing& timing, plot::Ink ink)
{
  const bool busy = std::isnan(timing.ns);
  chart.bar(timing.name, busy ? 0 : timing.ns, ink, busy ? time_text(timing.ns) : "");
}

} // namespace cookbook::measure
