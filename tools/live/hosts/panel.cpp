#include "tools/live/hosts/panel.hpp"

#include "tools/program/table.hpp"

#include <algorithm>
#include <limits>

namespace cookbook::live
{

namespace
{

constexpr int side = 280, margin = 12, below = 168;
constexpr int top = 34, input_height = 34, line = 18;

/// The colours of a panel, light or dark.
struct Colours
{
  SDL_Color back, raised, ink, muted, accent, error;
};

Colours colours(bool dark)
{
  return dark ? Colours{{21, 27, 35, 255},    {34, 43, 54, 255},   {226, 232, 240, 255},
                        {148, 160, 175, 255}, {94, 162, 236, 255}, {255, 122, 138, 255}}
              : Colours{{255, 255, 255, 255}, {232, 237, 243, 255}, {29, 39, 51, 255},
                        {92, 104, 120, 255},  {28, 95, 168, 255},   {200, 16, 46, 255}};
}

/// What a panel is drawn with.
struct Pen
{
  SDL_Renderer* renderer;
  Text& text;
  Colours colour;

  void box(double x, double y, double width, double height, SDL_Color c) const
  {
    SDL_SetRenderDrawColor(renderer, c.r, c.g, c.b, c.a);
    const SDL_FRect place = {float(x), float(y), float(width), float(height)};
    SDL_RenderFillRectF(renderer, &place);
  }

  void right(const std::string& words, double x, double y, SDL_Color c) const
  {
    text.draw(words, x - text.width(words), y, c);
  }

  /// A name at the left, its value at the right.
  void pair(const std::string& name, const std::string& value, double x, double y, double w) const
  {
    text.draw(name, x, y, colour.muted);
    right(value, x + w, y, colour.ink);
  }
};

void draw_input(const Pen& pen, const Input& input, bool chosen, double x, double y)
{
  const double width = side - 2 * margin;
  if (chosen)
  {
    pen.box(x - 6, y - 2, width + 12, input_height - 4, pen.colour.raised);
    pen.box(x - 6, y - 2, 3, input_height - 4, pen.colour.accent);
  }
  if (input.kind == InputKind::button)
  {
    pen.text.draw("▸ " + input.name, x + 2, y + 5, pen.colour.accent);
    return;
  }
  pen.pair(input.name, value_text(input), x + 2, y + 2, width - 4);
  double part = 0;
  if (input.kind == InputKind::slider && input.most > input.least)
  {
    part = (input.value.x() - input.least) / (input.most - input.least);
  }
  else if (input.kind == InputKind::choice && input.options.size() > 1)
  {
    part = input.value.x() / double(input.options.size() - 1);
  }
  else if (input.kind == InputKind::toggle)
  {
    part = input.value.x();
  }
  pen.box(x + 2, y + 23, width - 4, 2, chosen ? pen.colour.muted : pen.colour.raised);
  pen.box(x + 2, y + 23, (width - 4) * part, 2, pen.colour.accent);
  pen.box(x + 2 + (width - 10) * part, y + 20, 6, 8, pen.colour.accent);
}

void draw_inputs(const Pen& pen, const Controls& controls, const Parts& parts)
{
  const double x = parts.picture_width + margin;
  const std::string motion = motion_text(controls);
  pen.text.draw(motion, x, 8, pen.colour.accent);
  if (!motion.empty())
  {
    pen.right(
        "step " + std::to_string(controls.session.step()) + ", " +
            number(double(controls.session.step()) / 60) + " s",
        parts.width - margin, 8, pen.colour.muted);
  }
  const std::vector<Input> inputs = offered(controls.session);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    draw_input(pen, inputs[i], i == controls.chosen, x, top + double(i) * input_height);
  }
  double y = parts.height - margin - line;
  const std::vector<std::string> keys = keys_text(controls);
  for (std::size_t i = keys.size(); i-- > 0;)
  {
    pen.text.draw(keys[i], x + (i % 2 == 0 ? 0 : side / 2.0 - margin), y, pen.colour.muted);
    y -= i % 2 == 0 ? line : 0;
  }
}

void draw_numbers(const Pen& pen, const Controls& controls, const Parts& parts, double width)
{
  double y = parts.picture_height + margin;
  if (controls.session.moving())
  {
    pen.pair(
        "time of a step", number(std::round(controls.milliseconds * 1000) / 1000) + " ms", margin,
        y, width);
    y += line;
  }
  for (const Reading& one : controls.session.readings())
  {
    if (y + line > parts.height)
    {
      return;
    }
    const std::string unit = one.unit.empty() ? "" : " " + one.unit;
    pen.pair(one.name, one.value + unit, margin, y, width);
    y += line;
  }
}

void draw_curve(const Pen& pen, const Curve& curve, double x, double y, double width, double height)
{
  if (curve.points.size() < 2)
  {
    return;
  }
  double least = 0, most = std::numeric_limits<double>::min();
  for (const Eigen::Vector2d& point : curve.points)
  {
    least = std::min(least, point.y());
    most = std::max(most, point.y());
  }
  const std::string unit = curve.unit.empty() ? "" : " " + curve.unit;
  const std::string value = number(curve.points.back().y()) + unit;
  pen.box(x, y + line, width, height - line, pen.colour.raised);
  pen.text.draw(curve.name, x, y, pen.colour.muted);
  if (pen.text.width(curve.name + "  " + value) < width) // else it stands among the numbers alone
  {
    pen.right(value, x + width, y, pen.colour.ink);
  }
  const double first = curve.points.front().x();
  const double span = std::max(curve.points.back().x() - first, 1.0);
  std::vector<SDL_FPoint> points;
  const std::size_t stride = curve.points.size() / 600 + 1;
  for (std::size_t i = 0; i < curve.points.size(); i += stride)
  {
    const Eigen::Vector2d& point = curve.points[i];
    const double up = (point.y() - least) / (most - least);
    points.push_back(
        {float(x + (point.x() - first) / span * width),
         float(y + height - 2 - up * (height - line - 4))});
  }
  SDL_SetRenderDrawColor(
      pen.renderer, pen.colour.accent.r, pen.colour.accent.g, pen.colour.accent.b, 255);
  for (int twice = 0; twice < 2; ++twice) // a line is a pixel wide
  {
    SDL_RenderDrawLinesF(pen.renderer, points.data(), int(points.size()));
    for (SDL_FPoint& point : points)
    {
      point.y += 0.75F;
    }
  }
}

void draw_curves(const Pen& pen, const Session& session, const Parts& parts, double x, double width)
{
  const int count = int(std::min(session.curves().size(), std::size_t(4)));
  const int columns = count > 1 ? 2 : 1, rows = count > 2 ? 2 : 1;
  const double each = (width - (columns - 1) * margin) / columns;
  const double height = double(below - margin) / rows - margin / 2.0;
  for (int i = 0; i < count; ++i)
  {
    draw_curve(
        pen, session.curves()[std::size_t(i)], x + i % columns * (each + margin),
        parts.picture_height + margin / 2.0 + i / columns * (height + margin / 2.0), each, height);
  }
}

} // namespace

Parts parts_for(const Session& session, bool with_panel)
{
  const int width = session.picture_width(), height = session.picture_height();
  if (!with_panel)
  {
    return {width, height, width, height};
  }
  const int inputs = int(offered(session).size());
  const int needed = top + inputs * input_height + 6 * line;
  return {width, height, width + side, std::max(height + below, needed)};
}

PanelHit panel_hit(const Parts& parts, double x, double y)
{
  if (x < parts.picture_width || x >= parts.width || y < top)
  {
    return {-1, 0};
  }
  const double part = (x - parts.picture_width - margin) / (side - 2 * margin);
  return {int((y - top) / input_height), std::clamp(part, 0.0, 1.0)};
}

void draw_panel(SDL_Renderer* renderer, Text& text, const Controls& controls, const Parts& parts)
{
  const Pen pen{renderer, text, colours(controls.dark)};
  pen.box(parts.picture_width, 0, parts.width - parts.picture_width, parts.height, pen.colour.back);
  pen.box(0, parts.picture_height, parts.picture_width, parts.height, pen.colour.back);
  draw_inputs(pen, controls, parts);
  const double inner = parts.picture_width - 2 * margin;
  const bool curves = !controls.session.curves().empty();
  const double numbers = curves ? std::min(inner * 0.45, 320.0) : std::min(inner, 420.0);
  draw_numbers(pen, controls, parts, numbers);
  if (curves)
  {
    const double x = margin + numbers + 2 * margin;
    draw_curves(pen, controls.session, parts, x, parts.picture_width - margin - x);
  }
  if (!controls.message.empty())
  {
    pen.box(0, parts.height - line - 4, parts.picture_width, line + 4, pen.colour.raised);
    text.draw(controls.message, margin, parts.height - line - 2, pen.colour.error);
  }
}

} // namespace cookbook::live
