#include "tools/plot/annotate.hpp"

#include <array>
#include <cmath>

namespace cookbook::plot
{

using Eigen::Vector2d;

namespace
{

void avoid_square(Sketch& sketch, const Vector2d& at, double half)
{
  sketch.obstacles.rects.push_back({at.x() - half, at.y() - half, at.x() + half, at.y() + half});
}

} // namespace

void avoid_path(Sketch& sketch, const std::vector<Vector2d>& points, bool closed)
{
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
  {
    sketch.obstacles.segments.emplace_back(points[k], points[k + 1]);
  }
  if (closed && points.size() > 2)
  {
    sketch.obstacles.segments.emplace_back(points.back(), points.front());
  }
}

std::vector<Vector2d> circle_points(const Vector2d& center, double radius)
{
  constexpr int count = 40;
  std::vector<Vector2d> points;
  for (int k = 0; k < count; ++k)
  {
    const double angle = 6.283185307179586 * k / count;
    points.emplace_back(
        center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
  }
  return points;
}

void add_label(
    Sketch& sketch, const Vector2d& anchor, double clearance, const std::string& text, Side side,
    Ink ink)
{
  if (!text.empty())
  {
    sketch.labels.push_back({anchor, clearance, text, side, ink, text_size, false});
  }
}

Side side_towards(const Vector2d& direction)
{
  constexpr std::array<Side, 8> sides{Side::right,      Side::below_right, Side::below,
                                      Side::below_left, Side::left,        Side::above_left,
                                      Side::above,      Side::above_right};
  const double eighths = std::atan2(direction.y(), direction.x()) * 4 / 3.141592653589793;
  return sides[static_cast<std::size_t>(std::lround(eighths) + 8) % 8];
}

void draw_arrow(
    Sketch& sketch, const Vector2d& start, const Vector2d& end, Ink ink, const std::string& label,
    Side side)
{
  sketch.body += svg::arrow(start, end, {ink, Stroke::solid, 2});
  avoid_path(sketch, {start, end}, false);
  avoid_square(sketch, end, 3);
  const bool is_free = side == Side::automatic && (end - start).norm() > 1;
  add_label(sketch, end, 6, label, is_free ? side_towards(end - start) : side, ink);
}

void draw_dimension(
    Sketch& sketch, const Vector2d& start, const Vector2d& end, const std::string& label,
    double offset, Ink ink)
{
  const Vector2d span = end - start;
  const double length = span.norm();
  const Vector2d along = length > 0 ? Vector2d(span / length) : Vector2d(1, 0);
  const Vector2d left(along.y(), -along.x());
  const Vector2d p = start + offset * left;
  const Vector2d q = end + offset * left;
  const svg::Pen pen{ink, Stroke::solid, 1.3};
  if (std::abs(offset) > 1)
  {
    // Extension lines, a little past the dimension line.
    const Vector2d past = (offset > 0 ? 4.0 : -4.0) * left;
    sketch.body += svg::line(start, p + past, {Ink::muted, Stroke::solid, 0.8});
    sketch.body += svg::line(end, q + past, {Ink::muted, Stroke::solid, 0.8});
    avoid_path(sketch, {start, p + past}, false);
    avoid_path(sketch, {end, q + past}, false);
  }
  // Too short for heads between its ends: they point inwards from outside.
  const bool is_short = length < 26;
  const double tail = is_short ? 16 : 0;
  if (is_short)
  {
    sketch.body +=
        svg::arrow(p - tail * along, p, pen, 7) + svg::arrow(q + tail * along, q, pen, 7);
    sketch.body += svg::line(p, q, pen);
  }
  else
  {
    const Vector2d middle = (p + q) / 2;
    sketch.body += svg::arrow(middle, p, pen, 8) + svg::arrow(middle, q, pen, 8);
  }
  avoid_path(sketch, {p - tail * along, q + tail * along}, false);
  const Vector2d outward = offset < 0 ? Vector2d(-left) : left;
  add_label(sketch, (p + q) / 2, 7, label, side_towards(outward), ink);
}

void draw_contact(Sketch& sketch, const Vector2d& at, Ink ink, const std::string& label, Side side)
{
  sketch.body += svg::element(
      "circle", {{"class", "cb-open cb-" + std::string(css_name(ink))},
                 {"stroke-width", "1.5"},
                 {"cx", svg::number(at.x())},
                 {"cy", svg::number(at.y())},
                 {"r", "4.5"}});
  sketch.body += svg::circle(at, 1.8, {ink, Stroke::solid, 1}, Fill::solid);
  avoid_square(sketch, at, 5.5);
  add_label(sketch, at, 8, label, side, ink);
}

void draw_dot(Sketch& sketch, const Vector2d& at, Ink ink, const std::string& label, Side side)
{
  sketch.body += svg::circle(at, 2.4, {ink, Stroke::solid, 1}, Fill::solid);
  avoid_square(sketch, at, 3.5);
  add_label(sketch, at, 6, label, side, ink);
}

} // namespace cookbook::plot
