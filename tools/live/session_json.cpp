#include "tools/live/session.hpp"

#include "tools/plot/svg.hpp"
#include "tools/program/table.hpp"

#include <algorithm>

namespace cookbook::live
{

namespace
{

std::string quoted(const std::string& text)
{
  std::string out;
  out.reserve(text.size() + text.size() / 8 + 2);
  out += '"';
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
    }
    out += c == '\n' || static_cast<unsigned char>(c) >= 32 ? c : ' ';
    if (c == '\n')
    {
      out.back() = '\\';
      out += 'n';
    }
  }
  out += '"';
  return out;
}

/// A figure without its style sheet, which a page has already.
std::string without_style(const std::string& svg)
{
  const std::size_t begin = svg.find("<style>"), end = svg.find("</style>");
  return end == svg.npos ? svg : svg.substr(0, begin) + svg.substr(end + 8);
}

std::string member(const char* name, const std::string& json)
{
  return quoted(name) + ":" + json;
}

std::string flag(bool value)
{
  return value ? "true" : "false";
}

template <class Each, class Write>
std::string list(const Each& each, const Write& write)
{
  std::string out;
  for (const auto& one : each)
  {
    out += (out.empty() ? "" : ",") + write(one);
  }
  return "[" + out + "]";
}

std::string coordinate(double value)
{
  return plot::svg::number(std::clamp(value, -1e6, 1e6));
}

std::string input_json(const Input& input)
{
  static constexpr const char* kinds[] = {"slider", "choice", "toggle", "handle", "button", "file"};
  const Eigen::Vector2d& v = input.value;
  const Eigen::Vector2d pixel =
      input.plane.origin + v.x() * input.plane.across + v.y() * input.plane.up;
  std::string out =
      member("kind", quoted(kinds[int(input.kind)])) + "," + member("name", quoted(input.name)) +
      "," + member("event", quoted(event_name(input.name))) + "," +
      member("unit", quoted(input.unit)) + "," + member("x", number(v.x())) + "," +
      member("y", number(v.y())) + "," + member("least", number(input.least)) + "," +
      member("most", number(input.most)) + "," + member("options", list(input.options, quoted)) +
      "," + member("asked", flag(input.asked)) + "," + member("file", quoted(input.file.name));
  if (input.kind == InputKind::handle)
  {
    out += "," + member("px", coordinate(pixel.x())) + "," + member("py", coordinate(pixel.y())) +
           "," + member("ink", quoted(std::string(plot::css_name(input.ink))));
  }
  return "{" + out + "}";
}

std::string reading_json(const Reading& reading)
{
  return "{" + member("name", quoted(reading.name)) + "," + member("value", quoted(reading.value)) +
         "," + member("unit", quoted(reading.unit)) + "}";
}

} // namespace

std::string Session::json() const
{
  const Page& p = page_;
  return "{" + member("inputs", list(p.inputs_, input_json)) + "," +
         member("numbers", list(p.readings_, reading_json)) + "," +
         member("svg", quoted(without_style(p.svg_))) + "," +
         member("plots", quoted(without_style(curves_svg(std::min(p.width_, 760.0))))) + "," +
         member(
             "picture", "[" + std::to_string(p.picture_width_) + "," +
                            std::to_string(p.picture_height_) + "]") +
         "," +
         (p.grip_
              ? member(
                    "grip", "[" + coordinate(p.grip_->x()) + "," + coordinate(p.grip_->y()) + "]") +
                    ","
              : "") +
         member("moving", flag(p.moving_)) + "," + member("resting", flag(p.resting_)) + "," +
         member("step", std::to_string(p.step_)) + "," + member("state", quoted(state())) + "," +
         member("code", quoted(p.code_)) + "}";
}

} // namespace cookbook::live
