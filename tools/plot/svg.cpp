#include "tools/plot/svg.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace cookbook::plot::svg
{
namespace
{

using Eigen::Vector2d;

std::string classes(std::string_view role, Ink ink)
{
  return "cb-" + std::string(role) + " cb-" + std::string(css_name(ink));
}

std::string_view role(Fill fill)
{
  switch (fill)
  {
  case Fill::none:
    return "line";
  case Fill::wash:
    return "wash";
  case Fill::solid:
    return "solid";
  }
  return "line";
}

/// The corners of a regular star or polygon; every second corner lies at `inner` radius.
std::vector<Vector2d> star(const Vector2d& at, int corners, double outer, double inner, double turn)
{
  std::vector<Vector2d> points;
  for (int k = 0; k < corners; ++k)
  {
    const double angle = turn + 6.283185307179586 * k / corners;
    const double radius = k % 2 == 0 ? outer : inner;
    points.emplace_back(at.x() + radius * std::sin(angle), at.y() - radius * std::cos(angle));
  }
  return points;
}

/// Draws two crossing strokes.
std::string strokes(const Vector2d& at, const Vector2d& p, const Vector2d& q, Ink ink)
{
  const std::string data = path_data({at - p, at + p}, false) + path_data({at - q, at + q}, false);
  return path(data, {ink, Stroke::solid, 2.4}, Fill::none);
}

} // namespace

std::string number(double value)
{
  require_finite("number", value);
  if (std::abs(value) > 1e9)
  {
    throw std::invalid_argument("svg: number beyond 1e9");
  }
  const std::int64_t millionths = std::llround(value * 1e6);
  const std::int64_t hundredths = (std::abs(millionths) + 5000) / 10000;
  const std::string fraction = std::to_string(hundredths % 100);
  const char* const sign = millionths < 0 && hundredths != 0 ? "-" : "";
  return sign + std::to_string(hundredths / 100) + (fraction.size() < 2 ? ".0" : ".") + fraction;
}

std::string pair(const Vector2d& p)
{
  return number(p.x()) + "," + number(p.y());
}

std::string escaped(std::string_view text)
{
  std::string result;
  for (const char c : text)
  {
    switch (c)
    {
    case '&':
      result += "&amp;";
      break;
    case '<':
      result += "&lt;";
      break;
    case '>':
      result += "&gt;";
      break;
    case '"':
      result += "&quot;";
      break;
    case '\'':
      result += "&#39;";
      break;
    default:
      result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return result;
}

std::string element(
    std::string_view name, std::initializer_list<Attribute> attributes, std::string_view content)
{
  std::string result = "<" + std::string(name);
  for (const Attribute& attribute : attributes)
  {
    result += " " + std::string(attribute.first) + "=\"" + escaped(attribute.second) + "\"";
  }
  if (content.empty())
  {
    return result + "/>\n";
  }
  return result + ">" + std::string(content) + "</" + std::string(name) + ">\n";
}

std::string path_data(const std::vector<Vector2d>& points, bool closed)
{
  std::string data;
  for (const Vector2d& point : points)
  {
    data += (data.empty() ? "M" : "L") + pair(point);
  }
  return closed ? data + "Z" : data;
}

std::string path(const std::string& data, const Pen& pen, Fill fill)
{
  const std::string dashes(dash_array(pen.stroke));
  if (dashes.empty())
  {
    return element(
        "path", {{"class", classes(role(fill), pen.ink)},
                 {"stroke-width", number(pen.width)},
                 {"d", data}});
  }
  return element(
      "path", {{"class", classes(role(fill), pen.ink)},
               {"stroke-width", number(pen.width)},
               {"stroke-dasharray", dashes},
               {"d", data}});
}

std::string line(const Vector2d& p, const Vector2d& q, const Pen& pen)
{
  return polyline({p, q}, pen);
}

std::string polyline(const std::vector<Vector2d>& points, const Pen& pen)
{
  return path(path_data(points, false), pen, Fill::none);
}

std::string polygon(const std::vector<Vector2d>& points, const Pen& pen, Fill fill)
{
  return path(path_data(points, true), pen, fill);
}

std::string circle(const Vector2d& center, double radius, const Pen& pen, Fill fill)
{
  const std::string dashes(dash_array(pen.stroke));
  return element(
      "circle", {{"class", classes(role(fill), pen.ink)},
                 {"stroke-width", number(pen.width)},
                 {"stroke-dasharray", dashes.empty() ? "none" : dashes},
                 {"cx", number(center.x())},
                 {"cy", number(center.y())},
                 {"r", number(radius)}});
}

std::string filled(const std::string& path, Ink ink, double opacity)
{
  return element(
      "path", {{"class", classes("fill", ink)}, {"fill-opacity", number(opacity)}, {"d", path}});
}

std::string marker(Marker shape, const Vector2d& at, double size, Ink ink)
{
  const double r = size / 2;
  const Pen pen{ink, Stroke::solid, 1.2};
  switch (shape)
  {
  case Marker::none:
    return "";
  case Marker::circle:
    return circle(at, r, pen, Fill::solid);
  case Marker::square:
    return polygon(star(at, 4, 1.25 * r, 1.25 * r, 0.7853981633974483), pen, Fill::solid);
  case Marker::triangle:
    return polygon(star(at, 3, 1.3 * r, 1.3 * r, 0), pen, Fill::solid);
  case Marker::diamond:
    return polygon(star(at, 4, 1.35 * r, 1.35 * r, 0), pen, Fill::solid);
  case Marker::cross:
    return strokes(at, {r, r}, {r, -r}, ink);
  case Marker::plus:
    return strokes(at, {1.2 * r, 0}, {0, 1.2 * r}, ink);
  case Marker::inverted_triangle:
    return polygon(star(at, 3, 1.3 * r, 1.3 * r, 3.141592653589793), pen, Fill::solid);
  case Marker::star:
    return polygon(star(at, 10, 1.5 * r, 0.65 * r, 0), pen, Fill::solid);
  }
  return "";
}

std::string arrow(const Vector2d& start, const Vector2d& end, const Pen& pen, double head)
{
  const Vector2d span = end - start;
  const double length = span.norm();
  if (length < 0.5)
  {
    return circle(end, 1.5 * pen.width, pen, Fill::solid);
  }
  const Vector2d along = span / length;
  const Vector2d across(-along.y(), along.x());
  const double size = std::min(head, length);
  const Vector2d base = end - size * along;
  const Vector2d notch = end - 0.8 * size * along;
  const Vector2d side = 0.36 * size * across;
  return line(start, notch, pen) +
         filled(path_data({end, base + side, notch, base - side}, true), pen.ink, 1);
}

std::string clipped(
    const std::string& body, const std::string& id, double left, double top, double width,
    double height)
{
  const std::string rect = element(
      "rect", {{"x", number(left)},
               {"y", number(top)},
               {"width", number(width)},
               {"height", number(height)}});
  return element("clipPath", {{"id", id + "-clip"}}, "\n" + rect) +
         element("g", {{"clip-path", "url(#" + id + "-clip)"}}, "\n" + body);
}

std::string document(
    const std::string& name, double width, double height, const std::string& title,
    const std::string& description, const std::string& body)
{
  require_name(name);
  std::string content = "\n" + element("title", {{"id", name + "-title"}}, escaped(title));
  std::string labelled_by = name + "-title";
  if (!description.empty())
  {
    content += element("desc", {{"id", name + "-desc"}}, escaped(description));
    labelled_by += " " + name + "-desc";
  }
  content += "<style>\n" + std::string(style_sheet()) + "</style>\n";
  content += element(
      "rect",
      {{"class", "cb-paper"}, {"width", number(width)}, {"height", number(height)}, {"rx", "6"}});
  return element(
      "svg",
      {{"xmlns", "http://www.w3.org/2000/svg"},
       {"class", "cookbook-figure"},
       {"viewBox", "0 0 " + number(width) + " " + number(height)},
       {"width", number(width)},
       {"height", number(height)},
       {"role", "img"},
       {"aria-labelledby", labelled_by}},
      content + body);
}

void require_finite(std::string_view element, double value)
{
  if (!std::isfinite(value))
  {
    throw std::invalid_argument(
        "plot: " + std::string(element) + ": a value is " +
        (std::isnan(value) ? "NaN" : "infinite"));
  }
}

void require_name(const std::string& name)
{
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  bool good = !name.empty() && is_letter(name.front());
  for (const char c : name)
  {
    good = good && (is_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-');
  }
  if (!good)
  {
    throw std::invalid_argument(
        "plot: name \"" + name + "\" must be letters, digits, '_', '-' and begin with a letter");
  }
}

} // namespace cookbook::plot::svg
