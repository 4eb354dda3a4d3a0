#include "tools/live/page.hpp"

#include "tools/plot/charts/chart.hpp"
#include "tools/plot/panel.hpp"

#include <algorithm>

// A figure that plots nothing does without charts: they come with Page::plot alone.

namespace cookbook::live
{

namespace
{

std::string draw_curves(const std::vector<Curve>& curves, double width)
{
  plot::Grid grid("live_curves", "", width < 600 ? 1 : 2);
  const double each = width < 600 ? width : width / 2 - 8;
  std::size_t i = 0;
  for (const Curve& curve : curves)
  {
    std::vector<Eigen::Vector2d> points;
    const std::size_t stride = curve.points.size() / 300 + 1;
    for (std::size_t k = 0; k < curve.points.size(); k += stride)
    {
      points.emplace_back(curve.points[k].x() / 60, curve.points[k].y());
    }
    const std::string label = curve.name + (curve.unit.empty() ? "" : " [" + curve.unit + "]");
    plot::Chart chart("live_curves", "", {"time [s]"}, {label});
    chart.size(each, 180).legend(plot::Legend::none);
    chart.line(
        curve.name, points, {plot::series_ink(i++), plot::Marker::none, plot::Stroke::solid});
    grid.add(chart);
  }
  return grid.svg();
}

} // namespace

void Page::plot(const std::string& name, double value, const std::string& unit)
{
  if (steps_ == 0 && !begins_)
  {
    return;
  }
  draw_curves_ = draw_curves;
  auto curve = std::find_if(
      curves_.begin(), curves_.end(), [&](const Curve& one) { return one.name == name; });
  if (curve == curves_.end())
  {
    curve = curves_.insert(curve, {name, unit, {}});
  }
  curve->points.emplace_back(double(step_), value);
}

} // namespace cookbook::live
