#include "tools/live/session.hpp"
#include "tools/live/canonical.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cookbook::live
{

namespace
{

/// The parts of a text between separators, without empty ones.
std::vector<std::string> parts_of(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin)
    {
      parts.push_back(text.substr(begin, end - begin));
    }
    begin = end + 1;
  }
  return parts;
}

double finite(const std::string& event, const std::string& word)
{
  char* end = nullptr;
  const double value = std::strtod(word.c_str(), &end);
  if (end != word.c_str() + word.size() || !std::isfinite(value))
  {
    throw std::invalid_argument(
        "live: \"" + word + "\" is no number in the event \"" + event + "\"");
  }
  return canonical(value);
}

/// The event that gives an input its value.
std::string set_event(const Input& input, const Eigen::Vector2d& value)
{
  const std::string y = input.kind == InputKind::handle ? " " + written(value.y()) : "";
  return "set " + event_name(input.name) + " " + written(value.x()) + y;
}

/// A text as a word of an event: letters, digits, `-`, `.`, `_`, and all others as %XX.
std::string encoded(const std::string& text)
{
  static constexpr char digits[] = "0123456789ABCDEF";
  std::string word;
  for (const char c : text)
  {
    const unsigned byte = static_cast<unsigned char>(c);
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       c == '-' || c == '.' || c == '_';
    word += plain ? std::string(1, c) : std::string{'%', digits[byte / 16], digits[byte % 16]};
  }
  return word;
}

/// The text that a word of an event stands for.
std::string decoded(const std::string& word)
{
  const auto digit = [](char c)
  {
    const bool number = c >= '0' && c <= '9', large = c >= 'A' && c <= 'F';
    return number ? c - '0' : large ? c - 'A' + 10 : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
  };
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i)
  {
    if (word[i] != '%')
    {
      text += word[i];
      continue;
    }
    const int high = i + 2 < word.size() ? digit(word[i + 1]) : -1;
    const int low = high < 0 ? -1 : digit(word[i + 2]);
    if (low < 0)
    {
      throw std::invalid_argument("live: after % there must be two hexadecimal digits");
    }
    text += static_cast<char>(16 * high + low);
    i += 2;
  }
  return text;
}

/// The point of a drag plane that is seen at a pixel.
Eigen::Vector2d on_plane(const DragPlane& plane, const Eigen::Vector2d& pixel)
{
  const Eigen::Vector2d d = pixel - plane.origin;
  const auto cross = [](const Eigen::Vector2d& u, const Eigen::Vector2d& v)
  { return u.x() * v.y() - u.y() * v.x(); };
  const double area = cross(plane.across, plane.up);
  return area == 0
             ? Eigen::Vector2d(0, 0)
             : Eigen::Vector2d(
                   canonical(cross(d, plane.up) / area), canonical(cross(plane.across, d) / area));
}

/// The inputs that are not as at first, as events.
std::string differences(const std::vector<Input>& inputs)
{
  std::string text;
  for (const Input& input : inputs)
  {
    if (!input.file.name.empty())
    {
      text += file_event(input.name, input.file) + ";";
    }
    if (input.value != input.start)
    {
      text += set_event(input, input.value) + ";";
    }
  }
  return text;
}

} // namespace

std::string event_name(std::string name)
{
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::string file_event(const std::string& input, const File& file)
{
  return "file " + event_name(input) + " " + encoded(file.name) + " " + encoded(file.text);
}

Session::Session(std::function<void(Page&)> figure) : figure_(std::move(figure))
{
  call();
}

Input& Session::input(const std::string& name)
{
  for (Input& one : page_.inputs_)
  {
    if (event_name(one.name) == name)
    {
      return one;
    }
  }
  throw std::invalid_argument("live: there is no input \"" + name + "\"");
}

void Session::call()
{
  page_.readings_.clear();
  page_.svg_.clear();
  page_.code_.clear();
  page_.resting_ = false;
  for (Input& one : page_.inputs_)
  {
    one.asked = false;
  }
  if (page_.begins_)
  {
    page_.step_ = 0;
    page_.curves_.clear();
    log_.clear();
  }
  page_.step_ += page_.steps_;
  figure_(page_);
  base_ = page_.begins_ ? differences(page_.inputs_) : base_; // after it: a figure may close a file
  page_.begins_ = false;
  page_.steps_ = 0;
  page_.changed_.clear();
  page_.pressed_.clear();
  page_.pointer_.pressed = page_.pointer_.released = false;
  page_.pointer_.wheel = 0;
}

void Session::send(const std::string& events)
{
  for (const std::string& event : parts_of(events, '\n'))
  {
    one(event);
  }
}

void Session::set(Input& input, const Eigen::Vector2d& value)
{
  input.value = value;
  page_.changed_ = input.name;
  page_.begins_ = input.restarts;
  remember(set_event(input, value));
}

void Session::open(const std::string& name, const File& file)
{
  const Page before = page_;
  const std::vector<Done> log = log_;
  const std::string base = base_;
  Input& opened = input(name);
  opened.file = file;
  page_.changed_ = opened.name;
  page_.begins_ = opened.restarts;
  try
  {
    call();
  }
  catch (...) // as it was, where the figure cannot read the file
  {
    page_ = before;
    log_ = log;
    base_ = base;
    throw;
  }
  if (page_.step_ > 0 || !log_.empty())
  {
    remember(file_event(name, file));
  }
}

void Session::remember(const std::string& event)
{
  if (page_.moving_)
  {
    log_.push_back({page_.step_, event});
  }
}

void Session::point(const std::vector<std::string>& words, const std::string& event)
{
  Pointer& pointer = page_.pointer_;
  const std::string& what = words[3];
  const auto rounded = [&](int i)
  { return std::round(finite(event, words[std::size_t(i)]) * 10) / 10; };
  if (what != "down" && what != "up" && what != "move")
  {
    throw std::invalid_argument(
        "live: the pointer does \"" + what + "\" in the event \"" + event + "\"");
  }
  const Eigen::Vector2d at(rounded(1), rounded(2));
  const double wheel = words.size() > 4 ? finite(event, words[4]) : 0;
  const bool was_down = pointer.down;
  pointer.at = at;
  pointer.wheel = wheel;
  pointer.pressed = what == "down";
  pointer.released = what == "up" && was_down;
  pointer.down = what == "down" || (what == "move" && was_down);
  if (was_down || pointer.pressed || wheel != 0)
  {
    remember(
        "pointer " + written(at.x()) + " " + written(at.y()) + " " + what +
        (wheel != 0 ? " " + written(wheel) : ""));
  }
}

void Session::one(const std::string& event)
{
  const std::vector<std::string> words = parts_of(event, ' ');
  const std::string what = words.empty() ? "" : words[0];
  const std::size_t n = words.size();
  if (what == "set" && (n == 3 || n == 4))
  {
    Input& changed = input(words[1]);
    set(changed, {finite(event, words[2]), n == 4 ? finite(event, words[3]) : 0.0});
  }
  else if (what == "drag" && n == 4)
  {
    Input& changed = input(words[1]);
    set(changed, on_plane(changed.plane, {finite(event, words[2]), finite(event, words[3])}));
  }
  else if (what == "press" && n == 2)
  {
    page_.pressed_ = input(words[1]).name;
    remember(event);
  }
  else if (what == "file" && (n == 3 || n == 4))
  {
    open(words[1], {decoded(words[2]), n == 4 ? decoded(words[3]) : ""});
    return;
  }
  else if (what == "pointer" && (n == 4 || n == 5))
  {
    point(words, event);
  }
  else if (what == "step" && n == 2)
  {
    page_.steps_ = int(std::clamp(finite(event, words[1]), 0.0, 600.0));
  }
  else if (what == "reset" && n == 1)
  {
    page_.begins_ = true;
  }
  else if (what == "start" && n == 1)
  {
    for (Input& each : page_.inputs_)
    {
      each.value = each.start;
      each.file = {};
    }
    page_.pointer_ = {};
    page_.begins_ = true;
  }
  else if (what == "theme" && n == 2 && (words[1] == "dark" || words[1] == "light"))
  {
    page_.dark_ = words[1] == "dark";
  }
  else if (what == "width" && n == 2)
  {
    page_.width_ = std::clamp(finite(event, words[1]), 200.0, 2000.0);
  }
  else if (what == "restore")
  {
    restore(event.substr(std::min(event.size(), std::size_t(8))));
    return;
  }
  else
  {
    throw std::invalid_argument("live: there is no event \"" + event + "\"");
  }
  call();
}

void Session::restore(const std::string& state)
{
  one("start");
  for (const std::string& part : parts_of(state, ';'))
  {
    if (part[0] != '@')
    {
      one(part);
      continue;
    }
    constexpr long longest = 36'000; // ten minutes
    const long until = std::clamp(std::atol(part.c_str() + 1), 0L, longest);
    while (page_.moving_ && page_.step_ < until)
    {
      page_.steps_ = int(std::min(60L, until - page_.step_));
      call();
    }
  }
}

std::string Session::state() const
{
  if (!page_.moving_ || (page_.step_ == 0 && log_.empty()))
  {
    return differences(page_.inputs_);
  }
  std::string text = base_;
  long step = 0;
  for (const Done& done : log_)
  {
    text += (done.step != step ? "@" + std::to_string(done.step) + ";" : "") + done.event + ";";
    step = done.step;
  }
  text += page_.step_ != step ? "@" + std::to_string(page_.step_) + ";" : "";
  constexpr std::size_t longest = 6000; // what browsers take as an address without complaint
  return text.size() < longest ? text : differences(page_.inputs_);
}

std::string Session::curves_svg(double width) const
{
  const bool drawn = !page_.curves_.empty() && page_.curves_[0].points.size() > 1;
  return drawn ? page_.draw_curves_(page_.curves_, width) : "";
}

std::string Session::numbers() const
{
  std::string text;
  for (const Reading& one : page_.readings_)
  {
    text += one.name + " " + one.value + (one.unit.empty() ? "" : " " + one.unit) + "\n";
  }
  return text;
}

namespace
{

/// The value of an input in the pose of this number.
Eigen::Vector2d in_pose(const Input& input, int i, int pose)
{
  constexpr double pixels = 20;
  switch (input.kind)
  {
  case InputKind::slider:
    return {canonical(input.least + (input.most - input.least) * ((7 * pose + 3 * i) % 10) / 9), 0};
  case InputKind::choice:
    return {double(std::size_t(pose + i) % std::max<std::size_t>(1, input.options.size())), 0};
  case InputKind::toggle:
    return {double((pose + i) % 2), 0};
  default:
    break;
  }
  const double across = pixels / std::max(1.0, input.plane.across.norm());
  const double up = pixels / std::max(1.0, input.plane.up.norm());
  return {
      canonical(input.start.x() + ((3 * pose + i) % 7 - 3) * across),
      canonical(input.start.y() + ((5 * pose + i) % 7 - 3) * up)};
}

} // namespace

std::vector<std::string> Session::tour() const
{
  std::vector<std::string> poses;
  for (int pose = 0; pose < 10; ++pose)
  {
    std::string events;
    int i = 0;
    for (const Input& one : page_.inputs_)
    {
      if (one.kind == InputKind::file)
      {
        continue; // what a figure reads, its own test knows
      }
      if (one.kind != InputKind::button)
      {
        events += set_event(one, in_pose(one, i, pose)) + "\n";
      }
      else if (pose % 3 == 2)
      {
        events += "press " + event_name(one.name) + "\n";
      }
      ++i;
    }
    if (page_.picture_width_ > 0 && pose % 3 == 1)
    {
      const Eigen::Vector2d grip = page_.grip_.value_or(
          Eigen::Vector2d(page_.picture_width_ / 2, page_.picture_height_ / 2));
      const int x = int(grip.x()), y = int(grip.y());
      const auto at = [&](int dx, const char* what)
      { return "pointer " + std::to_string(x + dx) + " " + std::to_string(y) + " " + what + "\n"; };
      events += at(0, "down") + at(20, "move") + at(20, "up");
    }
    poses.push_back(events + (page_.moving_ ? "step 7\n" : ""));
  }
  return poses;
}

} // namespace cookbook::live
