#include "tools/plot/figures/figure2d.hpp"

#include "tools/plot/annotate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cookbook::plot
{
namespace
{

using Eigen::Vector2d;

/// Data of an arc to `end` on a circle, clockwise as seen.
std::string arc_to(const Vector2d& end, double radius, bool large)
{
  return "A" + svg::number(radius) + " " + svg::number(radius) + (large ? " 0 1 1 " : " 0 0 1 ") +
         svg::pair(end);
}

} // namespace

Figure2d::Figure2d(std::string name, std::string title, View view)
    : name_(std::move(name)), title_(std::move(title)), view_(view)
{
  svg::require_name(name_);
  for (const double value : {view.min.x(), view.min.y(), view.max.x(), view.max.y(), view.width})
  {
    svg::require_finite(name_ + " view", value);
  }
  if (!(view.max.x() > view.min.x() && view.max.y() > view.min.y() && view.width > 0))
  {
    throw std::invalid_argument("plot: " + name_ + " view: max must exceed min, width 0");
  }
  scale_ = view.width / (view.max.x() - view.min.x());
  origin_ = {-scale_ * view.min.x(), scale_ * view.max.y() + (title_height(title_, view_.width))};
}

Vector2d Figure2d::to_pixels(const Vector2d& world) const
{
  return {origin_.x() + scale_ * world.x(), origin_.y() - scale_ * world.y()};
}

Vector2d Figure2d::pixel(const char* element, const Vector2d& world) const
{
  svg::require_finite(name_ + " " + element, world.x());
  svg::require_finite(name_ + " " + element, world.y());
  return to_pixels(world);
}

std::vector<Vector2d>
Figure2d::pixels(const char* element, const std::vector<Vector2d>& points) const
{
  std::vector<Vector2d> result;
  for (const Vector2d& point : points)
  {
    result.push_back(pixel(element, point));
  }
  return result;
}

Figure2d& Figure2d::describe(std::string text)
{
  description_ = std::move(text);
  return *this;
}

Figure2d& Figure2d::circle(const Vector2d& center, double radius, Ink ink, Fill fill, Stroke stroke)
{
  const Vector2d at = pixel("circle", center);
  svg::require_finite(name_ + " circle", radius);
  sketch_.body += svg::circle(at, scale_ * std::abs(radius), {ink, stroke, 1.8}, fill);
  avoid_path(sketch_, circle_points(at, scale_ * std::abs(radius)), true);
  return *this;
}

Figure2d& Figure2d::shape(const std::vector<Vector2d>& corners, Ink ink, Fill fill, Stroke stroke)
{
  sketch_.body += svg::polygon(corners, {ink, stroke, 1.8}, fill);
  avoid_path(sketch_, corners, true);
  return *this;
}

Figure2d& Figure2d::box(
    const Vector2d& center, double angle, const Vector2d& half_extents, Ink ink, Fill fill,
    Stroke stroke)
{
  svg::require_finite(name_ + " box", angle);
  const Vector2d u = half_extents.x() * Vector2d(std::cos(angle), std::sin(angle));
  const Vector2d v = half_extents.y() * Vector2d(-std::sin(angle), std::cos(angle));
  return shape(
      pixels("box", {center - u - v, center + u - v, center + u + v, center - u + v}), ink, fill,
      stroke);
}

Figure2d& Figure2d::capsule(
    const Vector2d& start, const Vector2d& end, double radius, Ink ink, Fill fill, Stroke stroke)
{
  svg::require_finite(name_ + " capsule", radius);
  const Vector2d p = pixel("capsule", start);
  const Vector2d q = pixel("capsule", end);
  const double r = scale_ * radius;
  const double length = (q - p).norm();
  const Vector2d along = length > 0 ? Vector2d((q - p) / length) : Vector2d(1, 0);
  const Vector2d side(-r * along.y(), r * along.x());
  const std::string data = "M" + svg::pair(p - side) + "L" + svg::pair(q - side) +
                           arc_to(q + side, r, false) + "L" + svg::pair(p + side) +
                           arc_to(p - side, r, false) + "Z";
  sketch_.body += svg::path(data, {ink, stroke, 1.8}, fill);
  avoid_path(sketch_, {p - side, q - side}, false);
  avoid_path(sketch_, {p + side, q + side}, false);
  avoid_path(sketch_, circle_points(p, r), true);
  avoid_path(sketch_, circle_points(q, r), true);
  return *this;
}

Figure2d& Figure2d::polygon(const std::vector<Vector2d>& corners, Ink ink, Fill fill, Stroke stroke)
{
  return shape(pixels("polygon", corners), ink, fill, stroke);
}

Figure2d& Figure2d::region(const std::vector<Vector2d>& corners, Ink ink)
{
  sketch_.body += svg::filled(svg::path_data(pixels("region", corners), true), ink, 0.42);
  return *this;
}

Figure2d& Figure2d::lens(
    const Vector2d& center_a, double radius_a, const Vector2d& center_b, double radius_b, Ink ink)
{
  const Vector2d a = pixel("lens", center_a);
  const Vector2d b = pixel("lens", center_b);
  const double ra = scale_ * radius_a;
  const double rb = scale_ * radius_b;
  svg::require_finite(name_ + " lens", ra + rb);
  const double distance = (b - a).norm();
  if (distance >= ra + rb)
  {
    return *this;
  }
  if (distance <= std::abs(ra - rb))
  {
    // One circle holds the other: all of the smaller one.
    const Vector2d c = ra < rb ? a : b;
    const Vector2d r(std::min(ra, rb), 0);
    sketch_.body += svg::filled(
        "M" + svg::pair(c - r) + arc_to(c + r, r.x(), false) + arc_to(c - r, r.x(), false) + "Z",
        ink, 0.42);
    return *this;
  }
  const Vector2d u = (b - a) / distance;
  const double along = (distance * distance + ra * ra - rb * rb) / (2 * distance);
  const double half = std::sqrt(std::max(0.0, ra * ra - along * along));
  const Vector2d p = a + along * u - half * Vector2d(-u.y(), u.x());
  const Vector2d q = a + along * u + half * Vector2d(-u.y(), u.x());
  sketch_.body += svg::filled(
      "M" + svg::pair(p) + arc_to(q, ra, along < 0) + arc_to(p, rb, along > distance) + "Z", ink,
      0.42);
  return *this;
}

Figure2d& Figure2d::half_plane(const Vector2d& normal, double distance, Ink ink)
{
  svg::require_finite(name_ + " half_plane", distance);
  const double length = normal.norm();
  if (!(length > 0))
  {
    throw std::invalid_argument("plot: " + name_ + " half_plane: normal has no length");
  }
  const Vector2d n = normal / length;
  const Vector2d middle = (view_.min + view_.max) / 2;
  const Vector2d foot = middle + (distance / length - n.dot(middle)) * n;
  const Vector2d p = pixel("half_plane", foot);
  const Vector2d down(-n.x(), n.y()); // into the solid, pixels
  const Vector2d along(-down.y(), down.x());
  const double reach = scale_ * (view_.max - view_.min).norm();
  sketch_.body += svg::filled(
      svg::path_data(
          {p - reach * along, p + reach * along, p + reach * (along + down),
           p + reach * (down - along)},
          true),
      ink, 0.07);
  sketch_.body += svg::line(p - reach * along, p + reach * along, {ink, Stroke::solid, 1.8});
  avoid_path(sketch_, {p - reach * along, p + reach * along}, false);
  std::string strokes;
  for (double t = -reach; t < reach; t += 11)
  {
    const Vector2d top = p + t * along;
    const bool is_seen = top.x() > -12 && top.x() < view_.width + 12;
    strokes += is_seen ? svg::path_data({top, top + 9 * (down - along)}, false) : "";
  }
  sketch_.body += svg::path(strokes, {ink, Stroke::solid, 0.9}, Fill::none);
  return *this;
}

Figure2d& Figure2d::segment(
    const Vector2d& start, const Vector2d& end, Ink ink, Stroke stroke, double pixels_wide)
{
  return polyline({start, end}, ink, stroke, pixels_wide);
}

Figure2d&
Figure2d::polyline(const std::vector<Vector2d>& points, Ink ink, Stroke stroke, double pixels_wide)
{
  const std::vector<Vector2d> path = pixels("polyline", points);
  sketch_.body += svg::polyline(path, {ink, stroke, pixels_wide});
  avoid_path(sketch_, path, false);
  return *this;
}

Figure2d& Figure2d::arrow(
    const Vector2d& start, const Vector2d& end, Ink ink, const std::string& label, Side side)
{
  draw_arrow(sketch_, pixel("arrow", start), pixel("arrow", end), ink, label, side);
  return *this;
}

Figure2d& Figure2d::dimension(
    const Vector2d& start, const Vector2d& end, const std::string& label, double offset, Ink ink)
{
  svg::require_finite(name_ + " dimension", offset);
  draw_dimension(sketch_, pixel("dimension", start), pixel("dimension", end), label, offset, ink);
  return *this;
}

Figure2d& Figure2d::point(const Vector2d& position, Ink ink, const std::string& label, Side side)
{
  draw_contact(sketch_, pixel("point", position), ink, label, side);
  return *this;
}

Figure2d& Figure2d::dot(const Vector2d& position, Ink ink, const std::string& label, Side side)
{
  draw_dot(sketch_, pixel("dot", position), ink, label, side);
  return *this;
}

Figure2d& Figure2d::angle(
    const Vector2d& center, double radius, double from, double to, const std::string& label,
    Ink ink)
{
  const int steps = 24;
  std::vector<Vector2d> arc;
  for (int k = 0; k <= steps; ++k)
  {
    const double t = from + (to - from) * k / steps;
    arc.push_back(center + radius * Vector2d(std::cos(t), std::sin(t)));
  }
  const std::vector<Vector2d> path = pixels("angle", arc);
  sketch_.body += svg::polyline(path, {ink, Stroke::solid, 1.3});
  avoid_path(sketch_, path, false);
  const Vector2d& middle = path[static_cast<std::size_t>(steps) / 2];
  add_label(sketch_, middle, 5, label, side_towards(middle - to_pixels(center)), ink);
  return *this;
}

Figure2d& Figure2d::keep_free(const Vector2d& position, double pixels)
{
  const Vector2d at = pixel("free place", position), half = Vector2d::Constant(pixels / 2);
  const Vector2d least = at - half, most = at + half;
  sketch_.obstacles.rects.push_back({least.x(), least.y(), most.x(), most.y()});
  return *this;
}

Figure2d& Figure2d::label(const Vector2d& anchor, const std::string& text, Side side, Ink ink)
{
  add_label(sketch_, pixel("label", anchor), side == Side::centre ? 0 : 5, text, side, ink);
  return *this;
}

Figure2d& Figure2d::grid(double spacing)
{
  const double widest = (view_.max - view_.min).maxCoeff();
  if (!(spacing > widest / 200))
  {
    throw std::invalid_argument("plot: " + name_ + " grid: spacing too small or not a number");
  }
  std::string lines;
  for (int axis = 0; axis < 2; ++axis)
  {
    const int other = 1 - axis;
    for (double k = std::ceil(view_.min[axis] / spacing); k * spacing <= view_.max[axis]; ++k)
    {
      Vector2d p;
      Vector2d q;
      p[axis] = q[axis] = k * spacing;
      p[other] = view_.min[other];
      q[other] = view_.max[other];
      lines += svg::path_data({to_pixels(p), to_pixels(q)}, false);
    }
  }
  sketch_.body += svg::path(lines, {Ink::faint, Stroke::solid, 0.8}, Fill::none);
  return *this;
}

Figure2d& Figure2d::axes(double spacing, const std::string& x_label, const std::string& y_label)
{
  grid(spacing);
  const svg::Pen pen{Ink::muted, Stroke::solid, 1};
  const Vector2d o = to_pixels(Vector2d::Zero());
  const Vector2d right = to_pixels({view_.max.x(), 0}) - Vector2d(2, 0);
  const Vector2d top = to_pixels({0, view_.max.y()}) + Vector2d(0, 2);
  sketch_.body += svg::arrow(to_pixels({view_.min.x(), 0}), right, pen, 7);
  sketch_.body += svg::arrow(to_pixels({0, view_.min.y()}), top, pen, 7);
  avoid_path(sketch_, {o, right}, false);
  avoid_path(sketch_, {o, top}, false);
  add_label(sketch_, right - Vector2d(6, 0), 5, x_label, Side::above, Ink::muted);
  add_label(sketch_, top + Vector2d(0, 8), 5, y_label, Side::right, Ink::muted);
  return *this;
}

Panel Figure2d::panel(const std::string& id) const
{
  const double top = title_height(title_, view_.width);
  const double height = scale_ * (view_.max.y() - view_.min.y());
  Sketch sketch = sketch_;
  sketch.body = svg::clipped(sketch_.body, id, 0, top, view_.width, height);
  write_title(sketch, title_, view_.width);
  const Rect bounds{2, top + 2, view_.width - 2, top + height - 2};
  const std::vector<Rect> boxes = write_labels(sketch, bounds);
  return {view_.width, top + height, title_, description_, sketch.body, boxes};
}

std::vector<Rect> Figure2d::label_boxes() const
{
  return panel(name_).label_boxes;
}

std::string Figure2d::svg() const
{
  return document(name_, panel(name_));
}

} // namespace cookbook::plot
