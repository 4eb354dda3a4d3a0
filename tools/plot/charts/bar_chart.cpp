#include "tools/plot/charts/bar_chart.hpp"

#include "tools/plot/charts/chart_layout.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace cookbook::plot
{
namespace
{

constexpr double row_height = 28;
constexpr double thickness = 16;
constexpr double name_height = 16;

} // namespace

BarChart::BarChart(std::string name, std::string title, Axis value)
    : name_(std::move(name)), title_(std::move(title)), axis_(std::move(value))
{
  svg::require_name(name_);
  if (axis_.scale != Scale::linear)
  {
    throw std::invalid_argument("plot: " + name_ + ": bars need a linear axis");
  }
}

BarChart& BarChart::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

BarChart& BarChart::width(double pixels)
{
  if (!(pixels >= 160))
  {
    throw std::invalid_argument("plot: " + name_ + " width: at least 160 pixels");
  }
  width_ = pixels;
  return *this;
}

BarChart& BarChart::text_room(double negative, double positive)
{
  text_room_ = std::pair(negative, positive);
  return *this;
}

BarChart& BarChart::note(std::string text)
{
  note_ = std::move(text);
  return *this;
}

BarChart& BarChart::add(Bar bar)
{
  svg::require_finite(name_ + " bar " + bar.name, bar.value);
  if (bar.text.empty())
  {
    bar.text = significant(bar.value, 3);
  }
  bars_.push_back(std::move(bar));
  return *this;
}

BarChart& BarChart::bar(const std::string& name, double value, Ink ink, const std::string& text)
{
  return add({name, value, ink, text, false});
}

BarChart&
BarChart::highlight(const std::string& name, double value, Ink ink, const std::string& text)
{
  return add({name, value, ink, text, true});
}

BarChart& BarChart::reference(double value, const std::string& label)
{
  svg::require_finite(name_ + " reference " + label, value);
  references_.push_back({value, label});
  return *this;
}

Panel BarChart::panel(const std::string&) const
{
  std::vector<double> values{0};
  double names = 0;
  double low_text = 0;
  double high_text = 0;
  for (const Bar& bar : bars_)
  {
    values.push_back(bar.value);
    names = std::max(names, text_width(bar.name, text_size) * (bar.strong ? 1.06 : 1));
    double& room = bar.value < 0 ? low_text : high_text;
    room = std::max(room, text_width(bar.text, small_size) + 10);
  }
  for (const Reference& reference : references_)
  {
    values.push_back(reference.value);
  }
  const double top = title_height(title_, width_) + (references_.empty() ? 4 : 24);
  if (text_room_)
  {
    std::tie(low_text, high_text) = *text_room_;
  }
  // Long names stand on lines of their own, above their bars.
  const bool stacked = !text_room_ && names + low_text + high_text > 0.6 * width_;
  const double row = row_height + (stacked ? name_height : 0);
  const double bottom = top + row * static_cast<double>(bars_.size());
  const double left = (stacked ? 4 : names + 12) + low_text;
  const double right = width_ - std::max(16.0, high_text);
  const Range range = axis_range(axis_, values);
  const AxisMap map{Scale::linear, range, left, right};
  const double zero = map(std::clamp(0.0, range.min, range.max));

  Sketch sketch;
  write_title(sketch, title_, width_);
  for (const Tick& tick : axis_ticks(axis_, range, static_cast<int>((right - left) / 70) + 1))
  {
    const double x = map(tick.value);
    sketch.body += svg::line({x, top}, {x, bottom + 4}, {Ink::faint, Stroke::solid, 0.8});
    sketch.body +=
        svg::text({x, bottom + 19}, tick.text, {Ink::muted, small_size, false, "middle", 0});
  }
  for (std::size_t k = 0; k < bars_.size(); ++k)
  {
    const double middle = top + row * static_cast<double>(k + 1) - row_height / 2;
    draw_bar(sketch, bars_[k], middle, zero, map(bars_[k].value));
    const Bar& bar = bars_[k];
    sketch.body += svg::text(
        {0, stacked ? middle - 13 : middle + 5}, bar.name,
        {bar.strong ? bar.ink : Ink::ink, text_size, bar.strong});
  }
  sketch.body += svg::line({zero, top}, {zero, bottom + 4}, {Ink::muted, Stroke::solid, 1.2});
  for (const Reference& reference : references_)
  {
    const double x = map(reference.value);
    sketch.body += svg::line({x, top - 4}, {x, bottom}, {Ink::muted, Stroke::dashed, 1.2});
    sketch.labels.push_back(
        {{x, top - 4}, 4, reference.label, Side::above, Ink::muted, small_size});
  }
  double height = bottom + 26;
  if (!axis_.label.empty())
  {
    height += 18;
    sketch.body += svg::text(
        {(left + right) / 2, height - 6}, axis_.label, {Ink::muted, 13, false, "middle", 0});
  }
  if (!note_.empty())
  {
    height += 20;
    sketch.body += svg::text({0, height - 6}, note_, {Ink::muted, 11.5});
  }
  const Rect bounds{2, std::max(2.0, title_height(title_, width_) - 4), width_ - 2, height};
  const std::vector<Rect> boxes = write_labels(sketch, bounds);
  return {width_, height, title_, description_, sketch.body, boxes};
}

void BarChart::draw_bar(
    Sketch& sketch, const Bar& bar, double middle, double zero, double end) const
{
  const double low = std::min(zero, end);
  const double high = std::max(zero, end);
  const double half = thickness / 2;
  sketch.body += svg::filled(
      svg::path_data(
          {{low, middle - half},
           {high, middle - half},
           {high, middle + half},
           {low, middle + half}},
          true),
      bar.ink, bar.strong ? 1 : 0.5);
  const bool to_left = bar.value < 0;
  const Ink ink = bar.strong ? bar.ink : Ink::ink;
  sketch.body += svg::text(
      {end + (to_left ? -6 : 6), middle + 4.5}, bar.text,
      {ink, small_size, bar.strong, to_left ? "end" : "start", 0});
  sketch.obstacles.rects.push_back({low, middle - half, high, middle + half});
}

std::vector<Rect> BarChart::label_boxes() const
{
  return panel(name_).label_boxes;
}

std::string BarChart::svg() const
{
  return document(name_, panel(name_));
}

} // namespace cookbook::plot
