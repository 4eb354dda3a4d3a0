#include "tools/plot/charts/chart.hpp"

#include "tools/plot/charts/chart_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace cookbook::plot
{

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Where everything stands, in pixels.
struct Chart::Layout
{
  Rect plot; // between the axes, without failures and floor
  AxisMap x;
  AxisMap y;
  bool has_floor; // zeros on a logarithmic y axis
  std::vector<Tick> x_ticks;
  std::vector<Tick> y_ticks;
  std::vector<FailureSlot> failures;
  double failures_height;
  Legend legend;                 // never automatic
  std::vector<Vector2d> entries; // of a legend below: upper left corners
  double note_height;

  double bottom() const { return plot.bottom + (has_floor ? floor_strip : 0); }

  Vector2d at(const Vector2d& value) const
  {
    const bool on_floor = y.scale == Scale::log && value.y() == 0;
    return {x(value.x()), on_floor ? plot.bottom + floor_strip / 2 : y(value.y())};
  }
};

namespace
{

constexpr double marker_size = 8;
constexpr double axis_name_size = 13;
constexpr double note_size = 11.5;
constexpr double note_line = 16;
constexpr double note_gap = 8;      // [pixels] above the note
constexpr double sample_width = 33; // of a legend's entry, before its text

void avoid_marker(Sketch& sketch, const Vector2d& at)
{
  constexpr double half = 5.5;
  sketch.obstacles.rects.push_back({at.x() - half, at.y() - half, at.x() + half, at.y() + half});
}

/// The points of which no other is at most as far to the right and at most as high.
std::vector<Vector2d> not_beaten(std::vector<Vector2d> points)
{
  std::sort(
      points.begin(), points.end(),
      [](const Vector2d& p, const Vector2d& q)
      { return p.x() != q.x() ? p.x() < q.x() : p.y() < q.y(); });
  std::vector<Vector2d> corners;
  for (const Vector2d& point : points)
  {
    if (corners.empty() || point.y() < corners.back().y())
    {
      corners.push_back(point);
    }
  }
  return corners;
}

/// Draws the sample of a series in a legend.
void draw_sample(Sketch& sketch, double x, double y, const Look& look)
{
  sketch.body += svg::line({x, y}, {x + 26, y}, {look.ink, look.stroke, 2});
  sketch.body += svg::marker(look.marker, {x + 13, y}, marker_size - 1, look.ink);
}

/// How much of the drawing lies in a rectangle.
double crowd(const Obstacles& obstacles, const Rect& rect)
{
  double sum = 0;
  for (const Rect& other : obstacles.rects)
  {
    sum += overlap(rect, other) ? 3 : 0;
  }
  for (const auto& [p, q] : obstacles.segments)
  {
    for (int k = 0; k <= 8; ++k)
    {
      const Vector2d at = p + (q - p) * k / 8;
      const bool inside =
          at.x() > rect.left && at.x() < rect.right && at.y() > rect.top && at.y() < rect.bottom;
      sum += inside ? 0.25 : 0;
    }
  }
  return sum;
}

} // namespace

Look series_look(std::size_t index)
{
  return {series_ink(index), series_marker(index), series_stroke(index)};
}

Chart::Chart(std::string name, std::string title, Axis x, Axis y)
    : name_(std::move(name)), title_(std::move(title)), x_(std::move(x)), y_(std::move(y))
{
  svg::require_name(name_);
}

void Chart::check(const std::string& element, double x, double y) const
{
  svg::require_finite(name_ + " " + element, x);
  svg::require_finite(name_ + " " + element, y);
  if ((x_.scale == Scale::log && !(x > 0)) || (y_.scale == Scale::log && y < 0))
  {
    throw std::invalid_argument(
        "plot: " + name_ + " " + element + ": a value has no place on a logarithmic axis");
  }
}

Chart& Chart::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

Chart& Chart::size(double width, double height)
{
  if (!(width >= 160 && height >= 120))
  {
    throw std::invalid_argument("plot: " + name_ + " size: at least 160 by 120 pixels");
  }
  width_ = width;
  height_ = height;
  return *this;
}

Chart& Chart::legend(Legend legend)
{
  legend_ = legend;
  return *this;
}

Chart& Chart::note(std::string text)
{
  note_ = std::move(text);
  return *this;
}

Chart& Chart::leave_out(const std::string& label, const std::string& why)
{
  left_out_ += label + ": " + why + ". ";
  return *this;
}

Chart& Chart::name_failures(std::string label)
{
  failures_name_ = std::move(label);
  return *this;
}

Chart& Chart::line(const std::string& name, std::vector<Vector2d> points, Look look)
{
  for (const Vector2d& point : points)
  {
    check("line " + name, point.x(), point.y());
  }
  series_.push_back({name, std::move(points), look});
  return *this;
}

Chart& Chart::line(const std::string& name, std::vector<Vector2d> points)
{
  return line(name, std::move(points), series_look(series_.size()));
}

Chart& Chart::point(const std::string& label, const Vector2d& at, Look look)
{
  check("point " + label, at.x(), at.y());
  scatter_.push_back({label, at, at.y(), look});
  return *this;
}

Chart& Chart::whisker(const std::string& label, double x, double percentile, double max, Look look)
{
  check("whisker " + label, x, percentile);
  check("whisker " + label, x, max);
  scatter_.push_back({label, {x, max}, percentile, look});
  return *this;
}

Chart& Chart::band(const std::string& name, std::vector<Vector3d> rows, Ink ink)
{
  for (const Vector3d& row : rows)
  {
    check("band " + name, row.x(), row.y());
    check("band " + name, row.x(), row.z());
  }
  bands_.push_back({name, std::move(rows), ink});
  return *this;
}

Chart& Chart::front(std::vector<Vector2d> points, const std::string& label)
{
  for (const Vector2d& point : points)
  {
    check("front", point.x(), point.y());
  }
  front_ = not_beaten(std::move(points));
  front_label_ = label;
  return *this;
}

Chart& Chart::fails(const std::string& label, double x, Look look)
{
  check("fails " + label, x, 1);
  failures_.push_back({label, x, look});
  return *this;
}

Chart& Chart::reference_x(double value, const std::string& label)
{
  check("reference " + label, value, 1);
  references_.push_back({true, value, label});
  return *this;
}

Chart& Chart::reference_y(double value, const std::string& label)
{
  check("reference " + label, 1, value);
  references_.push_back({false, value, label});
  return *this;
}

std::vector<Vector2d> Chart::all_values() const
{
  std::vector<Vector2d> values(front_);
  for (const Series& series : series_)
  {
    values.insert(values.end(), series.points.begin(), series.points.end());
  }
  for (const Scatter& scatter : scatter_)
  {
    values.push_back(scatter.at);
    values.emplace_back(scatter.at.x(), scatter.percentile);
  }
  for (const Band& band : bands_)
  {
    for (const Vector3d& row : band.rows)
    {
      values.emplace_back(row.x(), row.y());
      values.emplace_back(row.x(), row.z());
    }
  }
  return values;
}

Chart::Layout Chart::layout() const
{
  Layout layout{};
  const std::vector<Vector2d> values = all_values();
  std::vector<double> xs;
  std::vector<double> ys;
  for (const Vector2d& value : values)
  {
    xs.push_back(value.x());
    ys.push_back(value.y());
    layout.has_floor = layout.has_floor || (y_.scale == Scale::log && value.y() == 0);
  }
  for (const Failure& failure : failures_)
  {
    xs.push_back(failure.x);
  }
  for (const Reference& reference : references_)
  {
    (reference.vertical ? xs : ys).push_back(reference.value);
  }
  const Range x_range = axis_range(x_, xs);
  const Range y_range = axis_range(y_, ys);

  // Across: the texts of the y axis on the left, names of series on the right.
  layout.y_ticks = axis_ticks(y_, y_range, std::max(3, static_cast<int>(height_ / 62)));
  double gutter = failures_.empty() ? 24 : text_width(failures_name_, small_size);
  for (const Tick& tick : layout.y_ticks)
  {
    gutter = std::max(gutter, text_width(tick.text, small_size));
  }
  double names = 0;
  std::size_t named = 0;
  for (const Series& series : series_)
  {
    names = std::max(names, text_width(series.name, text_size));
    named += series.name.empty() ? 0 : 1;
  }
  const bool has_room = named <= 6 && names < 0.28 * width_;
  layout.legend = legend_ != Legend::automatic ? legend_
                  : has_room                   ? Legend::direct
                                               : Legend::below;
  layout.plot.left = gutter + 10;
  layout.plot.right = width_ - (layout.legend == Legend::direct && named > 0 ? names + 18 : 16);
  layout.x = {x_.scale, x_range, layout.plot.left, layout.plot.right};
  layout.x_ticks = axis_ticks(
      x_, x_range, std::max(2, static_cast<int>((layout.plot.right - layout.plot.left) / 75)));

  // Down: title, name of the y axis, failures; floor, texts and name of the x axis, note.
  std::vector<std::string> labels;
  std::vector<double> pixels;
  for (const Failure& failure : failures_)
  {
    labels.push_back(failure.label);
    pixels.push_back(layout.x(failure.x));
  }
  layout.failures = failure_slots(labels, pixels, width_ - 4);
  int rows = 0;
  for (const FailureSlot& slot : layout.failures)
  {
    rows = std::max(rows, slot.row + 1);
  }
  layout.failures_height = rows == 0 ? 0 : 6 + rows * failure_row;
  const double name_lines = static_cast<double>(wrapped(y_.label, axis_name_size, width_).size());
  layout.plot.top = title_height(title_, width_) + 10 + 16 * name_lines + layout.failures_height;
  layout.note_height =
      note_line * static_cast<double>(wrapped(whole_note(), note_size, width_).size());
  layout.note_height += whole_note().empty() ? 0 : note_gap;
  layout.entries = legend_corners(layout.legend);
  const double legend_height = layout.entries.empty() ? 0 : layout.entries.back().y() + 24;
  layout.plot.bottom = height_ - 24 - (x_.label.empty() ? 0 : 21) - layout.note_height -
                       legend_height - (layout.has_floor ? floor_strip : 0);
  if (layout.plot.bottom < layout.plot.top + 40)
  {
    throw std::invalid_argument("plot: " + name_ + ": too small for what surrounds the axes");
  }
  layout.y = {y_.scale, y_range, layout.plot.bottom, layout.plot.top};
  return layout;
}

void Chart::draw_frame(Sketch& sketch, const Layout& layout) const
{
  const Rect& plot = layout.plot;
  const double bottom = layout.bottom();
  const svg::Pen grid{Ink::faint, Stroke::solid, 0.8};
  const svg::Pen axis{Ink::muted, Stroke::solid, 1};
  const svg::Type small{Ink::muted, small_size, false, "middle", 0};
  svg::Type on_left = small;
  on_left.anchor = "end";
  for (const Tick& tick : layout.x_ticks)
  {
    const double x = layout.x(tick.value);
    const bool named = !tick.text.empty();
    sketch.body += named ? svg::line({x, plot.top}, {x, bottom}, grid) : "";
    sketch.body += svg::line({x, bottom}, {x, bottom + (named ? 5 : 3)}, axis);
    sketch.body += named ? svg::text({x, bottom + 19}, tick.text, small) : "";
  }
  for (const Tick& tick : layout.y_ticks)
  {
    const double y = layout.y(tick.value);
    const bool named = !tick.text.empty();
    sketch.body += named ? svg::line({plot.left, y}, {plot.right, y}, grid)
                         : svg::line({plot.left - 3, y}, {plot.left, y}, axis);
    sketch.body += named ? svg::text({plot.left - 8, y + 4.5}, tick.text, on_left) : "";
  }
  if (layout.has_floor)
  {
    const double y = plot.bottom + floor_strip / 2;
    sketch.body += svg::line(
        {plot.left, plot.bottom}, {plot.right, plot.bottom}, {Ink::muted, Stroke::dotted, 1});
    sketch.body += svg::text({plot.left - 8, y + 4.5}, "0", on_left);
  }
  sketch.body += svg::line({plot.left, bottom}, {plot.right, bottom}, axis);
  double baseline = title_height(title_, width_) + 13;
  for (const std::string& words : wrapped(y_.label, axis_name_size, width_))
  {
    sketch.body += svg::text({0, baseline}, words, {Ink::muted, axis_name_size});
    baseline += 16;
  }
  sketch.body += svg::text(
      {(plot.left + plot.right) / 2, bottom + 40}, x_.label,
      {Ink::muted, axis_name_size, false, "middle", 0});
  baseline = height_ - layout.note_height + note_gap + note_line - 4;
  for (const std::string& words : wrapped(whole_note(), note_size, width_))
  {
    sketch.body += svg::text({0, baseline}, words, {Ink::muted, note_size});
    baseline += note_line;
  }
}

void Chart::draw_references(Sketch& sketch, const Layout& layout) const
{
  const Rect& plot = layout.plot;
  for (const Reference& reference : references_)
  {
    const double at = reference.vertical ? layout.x(reference.value) : layout.y(reference.value);
    const Vector2d p = reference.vertical ? Vector2d(at, layout.bottom()) : Vector2d(plot.left, at);
    const Vector2d q = reference.vertical ? Vector2d(at, plot.top) : Vector2d(plot.right, at);
    sketch.body += svg::line(p, q, {Ink::muted, Stroke::dashed, 1.2});
    sketch.obstacles.segments.emplace_back(p, q);
    const double half = text_width(reference.label, small_size) / 2;
    const Vector2d anchor =
        reference.vertical ? Vector2d(at, plot.top + 10) : Vector2d(plot.right - half - 4, at);
    sketch.labels.push_back(
        {anchor, 4, reference.label, reference.vertical ? Side::right : Side::above, Ink::muted,
         small_size});
  }
}

void Chart::draw_series(Sketch& sketch, const Layout& layout) const
{
  for (const Band& band : bands_)
  {
    std::vector<Vector2d> outline;
    for (const Vector3d& row : band.rows)
    {
      outline.push_back(layout.at({row.x(), row.z()}));
    }
    for (auto row = band.rows.rbegin(); row != band.rows.rend(); ++row)
    {
      outline.push_back(layout.at({row->x(), row->y()}));
    }
    sketch.body += svg::filled(svg::path_data(outline, true), band.ink, 0.16);
    if (!band.name.empty() && !band.rows.empty())
    {
      const Vector3d& row = band.rows[band.rows.size() * 3 / 4];
      sketch.labels.push_back(
          {layout.at({row.x(), row.z()}), 4, band.name, Side::below, band.ink, small_size});
    }
  }
  for (const Series& series : series_)
  {
    std::vector<Vector2d> path;
    for (const Vector2d& point : series.points)
    {
      path.push_back(layout.at(point));
    }
    sketch.body += svg::polyline(path, {series.look.ink, series.look.stroke, 2});
    for (std::size_t k = 0; k + 1 < path.size(); ++k)
    {
      sketch.obstacles.segments.emplace_back(path[k], path[k + 1]);
    }
    // A dozen markers tell a line apart; more hide it.
    const std::size_t stride = path.size() > 24 ? path.size() / 12 : 1;
    for (std::size_t k = 0; k < path.size(); k += stride)
    {
      sketch.body += svg::marker(series.look.marker, path[k], marker_size - 1, series.look.ink);
      if (series.look.marker != Marker::none)
      {
        avoid_marker(sketch, path[k]);
      }
    }
  }
}

void Chart::draw_front(Sketch& sketch, const Layout& layout) const
{
  if (front_.empty())
  {
    return;
  }
  std::vector<Vector2d> path;
  for (const Vector2d& point : front_)
  {
    path.push_back(layout.at(point));
  }
  sketch.body += svg::element(
      "path", {{"class", "cb-line cb-muted"},
               {"stroke-width", "2.6"},
               {"stroke-opacity", "0.38"},
               {"d", svg::path_data(path, false)}});
  for (const Vector2d& at : path)
  {
    sketch.body += svg::circle(at, marker_size, {Ink::muted, Stroke::solid, 1.2}, Fill::none);
  }
  Vector2d anchor = path.front();
  double longest = -1;
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
  {
    sketch.obstacles.segments.emplace_back(path[k], path[k + 1]);
    const double run = (path[k + 1] - path[k]).norm();
    anchor = run > longest ? Vector2d((path[k] + path[k + 1]) / 2) : anchor;
    longest = std::max(longest, run);
  }
  if (!front_label_.empty())
  {
    sketch.labels.push_back({anchor, 4, front_label_, Side::below, Ink::muted, small_size});
  }
}

void Chart::draw_points(Sketch& sketch, const Layout& layout) const
{
  for (const Scatter& scatter : scatter_)
  {
    const Vector2d at = layout.at(scatter.at);
    const Vector2d low = layout.at({scatter.at.x(), scatter.percentile});
    if (scatter.percentile != scatter.at.y())
    {
      const Vector2d half(4, 0);
      sketch.body += svg::line(low, at, {scatter.look.ink, Stroke::solid, 1.3});
      sketch.body += svg::line(low - half, low + half, {scatter.look.ink, Stroke::solid, 1.6});
      sketch.obstacles.segments.emplace_back(low, at);
    }
    avoid_marker(sketch, at);
  }
  for (const Scatter& scatter : scatter_)
  {
    const Vector2d at = layout.at(scatter.at);
    sketch.body += svg::marker(scatter.look.marker, at, marker_size, scatter.look.ink);
    if (!scatter.label.empty())
    {
      sketch.labels.push_back(
          {at, 8, scatter.label, Side::automatic, scatter.look.ink, small_size});
    }
  }
}

void Chart::draw_failures(Sketch& sketch, const Layout& layout) const
{
  if (failures_.empty())
  {
    return;
  }
  const Rect& plot = layout.plot;
  const double top = plot.top - layout.failures_height;
  const Ink ink = Ink::overlap;
  sketch.body += svg::filled(
      svg::path_data(
          {{plot.left, top}, {plot.right, top}, {plot.right, plot.top}, {plot.left, plot.top}},
          true),
      ink, 0.07);
  sketch.body +=
      svg::line({plot.left, plot.top}, {plot.right, plot.top}, {ink, Stroke::solid, 1.6});
  const double foot = plot.top - 10;
  sketch.body +=
      svg::text({plot.left - 8, foot + 4}, failures_name_, {ink, small_size, true, "end", 0});
  for (std::size_t k = 0; k < failures_.size(); ++k)
  {
    const FailureSlot& slot = layout.failures[k];
    const double row = foot - slot.row * failure_row;
    if (slot.row > 0)
    {
      sketch.body += svg::line({slot.x, foot}, {slot.x, row}, {Ink::muted, Stroke::solid, 0.8});
    }
    const double shift = slot.row > 0 ? 5 : 10;
    sketch.body += svg::text(
        {slot.x + (slot.to_left ? -shift : shift), row + 4.5}, failures_[k].label,
        {Ink::ink, small_size, false, slot.to_left ? "end" : "start", 0});
  }
  for (std::size_t k = 0; k < failures_.size(); ++k)
  {
    const Look& look = failures_[k].look;
    sketch.body += svg::marker(look.marker, {layout.failures[k].x, foot}, marker_size, look.ink);
  }
}

void Chart::draw_direct_names(Sketch& sketch, const Layout& layout) const
{
  std::vector<const Series*> named;
  std::vector<double> wanted;
  for (const Series& series : series_)
  {
    if (!series.name.empty() && !series.points.empty())
    {
      named.push_back(&series);
      wanted.push_back(layout.at(series.points.back()).y());
    }
  }
  const std::vector<double> heights =
      spread(wanted, text_size + 4, layout.plot.top + 6, layout.bottom() - 6);
  for (std::size_t k = 0; k < named.size(); ++k)
  {
    const Vector2d end = layout.at(named[k]->points.back());
    const Vector2d text(layout.plot.right + 10, heights[k]);
    if (std::abs(end.y() - text.y()) > 3 || text.x() - end.x() > 24)
    {
      sketch.body +=
          svg::line(end + Vector2d(6, 0), text - Vector2d(3, 0), {Ink::muted, Stroke::solid, 0.7});
    }
    sketch.body += svg::text(text + Vector2d(0, 5), named[k]->name, {named[k]->look.ink});
    const double width = text_width(named[k]->name, text_size);
    sketch.obstacles.rects.push_back({text.x(), text.y() - 8, text.x() + width, text.y() + 8});
  }
}

std::vector<std::pair<std::string, Look>> Chart::legend_rows() const
{
  std::vector<std::pair<std::string, Look>> rows;
  for (const Series& series : series_)
  {
    if (!series.name.empty())
    {
      rows.emplace_back(series.name, series.look);
    }
  }
  return rows;
}

std::vector<Vector2d> Chart::legend_corners(Legend legend) const
{
  std::vector<Vector2d> corners;
  double x = 0;
  double y = 0;
  if (legend == Legend::below)
  {
    for (const auto& [name, look] : legend_rows())
    {
      const double width = sample_width + text_width(name, small_size) + 16;
      y += x > 0 && x + width > width_ ? 19 : 0;
      x = x > 0 && x + width > width_ ? 0 : x;
      corners.emplace_back(x, y);
      x += width;
    }
  }
  return corners;
}

void Chart::draw_legend_below(Sketch& sketch, const Layout& layout) const
{
  const std::vector<std::pair<std::string, Look>> rows = legend_rows();
  const double top = layout.bottom() + (x_.label.empty() ? 24 : 45) + 12;
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const Vector2d at = layout.entries[k] + Vector2d(0, top);
    draw_sample(sketch, at.x(), at.y(), rows[k].second);
    sketch.body +=
        svg::text({at.x() + sample_width, at.y() + 4.5}, rows[k].first, {Ink::ink, small_size});
  }
}

void Chart::draw_corner_legend(Sketch& sketch, const Layout& layout) const
{
  const std::vector<std::pair<std::string, Look>> rows = legend_rows();
  if (rows.empty())
  {
    return;
  }
  double widest = 0;
  for (const auto& [name, look] : rows)
  {
    widest = std::max(widest, text_width(name, small_size));
  }
  const double width = widest + 50;
  const double height = 19 * static_cast<double>(rows.size()) + 8;
  const Rect& plot = layout.plot;
  // Take the emptiest corner.
  Rect box{};
  double least = -1;
  for (const auto& [x, y] : std::array<std::pair<double, double>, 4>{
           {{plot.right - width - 6, plot.top + 6},
            {plot.left + 8, plot.top + 6},
            {plot.right - width - 6, layout.bottom() - height - 8},
            {plot.left + 8, layout.bottom() - height - 8}}})
  {
    const Rect corner{x, y, x + width, y + height};
    const double crowded = crowd(sketch.obstacles, corner);
    if (least < 0 || crowded < least)
    {
      least = crowded;
      box = corner;
    }
  }
  sketch.body += svg::element(
      "rect", {{"class", "cb-open cb-faint"},
               {"fill-opacity", "0.88"},
               {"x", svg::number(box.left)},
               {"y", svg::number(box.top)},
               {"width", svg::number(width)},
               {"height", svg::number(height)},
               {"rx", "4"}});
  for (std::size_t k = 0; k < rows.size(); ++k)
  {
    const double y = box.top + 14 + 19 * static_cast<double>(k);
    draw_sample(sketch, box.left + 8, y, rows[k].second);
    sketch.body +=
        svg::text({box.left + 8 + sample_width, y + 4.5}, rows[k].first, {Ink::ink, small_size});
  }
  sketch.obstacles.rects.push_back(box);
}

Panel Chart::panel(const std::string& id) const
{
  const Layout where = layout();
  Sketch data;
  draw_references(data, where);
  draw_front(data, where);
  draw_series(data, where);
  draw_points(data, where);

  // Only what is measured is clipped, where an axis has fixed limits.
  const Rect& plot = where.plot;
  constexpr double bleed = 7;
  Sketch sketch;
  write_title(sketch, title_, width_);
  draw_frame(sketch, where);
  sketch.body += svg::clipped(
      data.body, id, plot.left - bleed, plot.top - bleed, plot.right - plot.left + 2 * bleed,
      where.bottom() - plot.top + 2 * bleed);
  sketch.labels = data.labels;
  sketch.obstacles = data.obstacles;
  draw_failures(sketch, where);
  switch (where.legend)
  {
  case Legend::direct:
    draw_direct_names(sketch, where);
    break;
  case Legend::corner:
    draw_corner_legend(sketch, where);
    break;
  case Legend::below:
    draw_legend_below(sketch, where);
    break;
  case Legend::automatic:
  case Legend::none:
    break;
  }
  const Rect bounds{plot.left + 2, plot.top + 2, width_ - 2, where.bottom() - 2};
  const std::vector<Rect> boxes = write_labels(sketch, bounds);
  return {width_, height_, title_, description_, sketch.body, boxes};
}

std::vector<Rect> Chart::label_boxes() const
{
  return panel(name_).label_boxes;
}

std::string Chart::svg() const
{
  return document(name_, panel(name_));
}

} // namespace cookbook::plot
