#include "tools/plot/panel.hpp"

#include <algorithm>
#include <stdexcept>

namespace cookbook::plot
{

std::vector<Rect> write_labels(Sketch& sketch, const Rect& bounds)
{
  const std::vector<PlacedLabel> places = place_labels(sketch.labels, sketch.obstacles, bounds);
  std::vector<Rect> boxes;
  for (const PlacedLabel& place : places)
  {
    if (place.leader)
    {
      const auto& [start, end] = place.leader_line;
      sketch.body += svg::line(start, end, {Ink::muted, Stroke::solid, 0.8});
    }
    boxes.push_back(place.box);
  }
  for (const PlacedLabel& place : places)
  {
    const Label& label = place.label;
    sketch.body += svg::text(
        place.baseline, label.text,
        {label.ink, label.font_size, label.strong, place.text_anchor, 0});
  }
  return boxes;
}

double title_height(const std::string& title, double width)
{
  const std::size_t lines = wrapped(title, 1.06 * title_size, width).size();
  return lines == 0 ? 0 : 12 + 19 * static_cast<double>(lines);
}

void write_title(Sketch& sketch, const std::string& title, double width)
{
  double baseline = 17;
  for (const std::string& line : wrapped(title, 1.06 * title_size, width))
  {
    sketch.body += svg::text({0, baseline}, line, {Ink::ink, title_size, true, "start", 0});
    baseline += 19;
  }
}

std::string document(const std::string& name, const Panel& panel)
{
  constexpr double margin = document_margin;
  const std::string body = svg::element(
      "g", {{"transform", "translate(" + svg::pair({margin, margin}) + ")"}}, "\n" + panel.body);
  return svg::document(
      name, panel.width + 2 * margin, panel.height + 2 * margin,
      panel.title.empty() ? name : panel.title, panel.description, body);
}

Grid::Grid(std::string name, std::string title, int columns)
    : name_(std::move(name)), title_(std::move(title)), columns_(columns)
{
  svg::require_name(name_);
  if (columns_ < 1)
  {
    throw std::invalid_argument("plot: grid \"" + name_ + "\" needs at least one column");
  }
}

Grid& Grid::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

Panel Grid::panel(const std::string& id) const
{
  constexpr double gap = 22;
  std::vector<Panel> panels;
  std::vector<double> widths(static_cast<std::size_t>(columns_), 0.0);
  std::vector<double> heights;
  for (std::size_t k = 0; k < panels_.size(); ++k)
  {
    panels.push_back(panels_[k](id + "-" + std::to_string(k + 1)));
    const std::size_t column = k % widths.size();
    heights.resize(k / widths.size() + 1, 0.0);
    widths[column] = std::max(widths[column], panels[k].width);
    heights.back() = std::max(heights.back(), panels[k].height);
  }
  double total = -gap;
  for (const double width : widths)
  {
    total += width > 0 ? width + gap : 0;
  }
  Sketch head;
  write_title(head, title_, total);
  Panel result{0, title_height(title_, total), title_, description_, head.body, {}};
  double x = 0;
  for (std::size_t k = 0; k < panels.size(); ++k)
  {
    const std::size_t column = k % widths.size();
    x = column == 0 ? 0 : x;
    const Eigen::Vector2d shift(x, result.height);
    result.body += svg::element(
        "g", {{"transform", "translate(" + svg::pair(shift) + ")"}}, "\n" + panels[k].body);
    for (const Rect& box : panels[k].label_boxes)
    {
      result.label_boxes.push_back(
          {box.left + shift.x(), box.top + shift.y(), box.right + shift.x(),
           box.bottom + shift.y()});
    }
    x += widths[column] + gap;
    result.width = std::max(result.width, x - gap);
    const bool row_ends = column + 1 == widths.size() || k + 1 == panels.size();
    result.height += row_ends ? heights[k / widths.size()] + (k + 1 < panels.size() ? gap : 0) : 0;
  }
  return result;
}

std::string Grid::svg() const
{
  return document(name_, panel(name_));
}

} // namespace cookbook::plot
