#include "tools/live/hosts/controls.hpp"

#include "tools/live/hosts.hpp"
#include "tools/program/table.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace cookbook::live
{

void run_host(const std::string& host, const std::string& name, Session& session)
{
  need_picture(name, session);
  host == "terminal" ? run_terminal(name, session) : run_window(name, session);
}

void need_picture(const std::string& name, const Session& session)
{
  if (session.picture_width() <= 0 || session.picture_height() <= 0)
  {
    throw std::runtime_error(
        "the figure " + name + " is a drawing, which only its page shows (./cookbook book)");
  }
}

void send(Controls& controls, const std::string& events)
{
  try
  {
    controls.session.send(events);
    controls.message.clear();
  }
  catch (const std::exception& error)
  {
    controls.message = error.what();
  }
}

void open_file(Session& session, const std::filesystem::path& path)
{
  for (const Input& input : session.inputs())
  {
    if (input.kind == InputKind::file)
    {
      std::ifstream stream(path, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      if (!stream || std::filesystem::is_directory(path))
      {
        throw std::runtime_error("cannot read " + path.string());
      }
      session.send(file_event(input.name, {path.filename().string(), text}));
      return;
    }
  }
  throw std::runtime_error("this figure opens no files");
}

void open_file(Controls& controls, const std::filesystem::path& path)
{
  try
  {
    open_file(controls.session, path);
    controls.message.clear();
  }
  catch (const std::exception& error)
  {
    controls.message = error.what();
  }
}

std::vector<Input> offered(const Session& session)
{
  std::vector<Input> inputs;
  for (const Input& one : session.inputs())
  {
    if (one.asked && one.kind != InputKind::handle)
    {
      inputs.push_back(one);
    }
  }
  return inputs;
}

void change(Controls& controls, const Input& input, int by)
{
  double value = input.value.x() + by;
  if (input.kind == InputKind::button || input.kind == InputKind::file)
  {
    return;
  }
  if (input.kind == InputKind::slider)
  {
    value = input.value.x() + by * (input.most - input.least) / 100;
    value = std::clamp(value, input.least, input.most);
  }
  else if (input.kind == InputKind::toggle)
  {
    value = input.value.x() == 0 ? 1 : 0;
  }
  else
  {
    const int count = int(input.options.size());
    value = (int(input.value.x()) + by % count + count) % count;
  }
  char text[32];
  std::snprintf(text, sizeof text, " %.6g", value);
  send(controls, "set " + event_name(input.name) + text);
}

namespace
{

/// Keys that choose an input, and those that change the one that is chosen.
void press_input_key(Controls& controls, const std::string& key)
{
  const std::vector<Input> inputs = offered(controls.session);
  if (inputs.empty())
  {
    return;
  }
  controls.chosen = std::min(controls.chosen, inputs.size() - 1);
  const Input& input = inputs[controls.chosen];
  if (key == "tab" || key == "down")
  {
    controls.chosen = (controls.chosen + 1) % inputs.size();
  }
  else if (key == "up")
  {
    controls.chosen = (controls.chosen + inputs.size() - 1) % inputs.size();
  }
  else if (key == "left" || key == "-")
  {
    change(controls, input, -1);
  }
  else if (key == "right" || key == "+" || key == "=")
  {
    change(controls, input, 1);
  }
  else if (key == "enter" && input.kind == InputKind::button)
  {
    send(controls, "press " + event_name(input.name));
  }
  else if (key == "enter" && input.kind != InputKind::slider)
  {
    change(controls, input, 1);
  }
}

} // namespace

void press_key(Controls& controls, const std::string& key)
{
  if (key == "escape" || key == "q")
  {
    controls.closed = true;
  }
  else if (key == "space")
  {
    controls.playing = !controls.playing;
  }
  else if (key == ".")
  {
    controls.playing = false;
    send(controls, "step 1");
  }
  else if (key == "r")
  {
    send(controls, "reset");
  }
  else if (key == "s")
  {
    send(controls, "start");
  }
  else if (key == "d")
  {
    controls.dark = !controls.dark;
    send(controls, controls.dark ? "theme dark" : "theme light");
  }
  else
  {
    press_input_key(controls, key);
  }
}

void advance(Controls& controls, int steps)
{
  if (steps <= 0 || !controls.playing || !controls.session.moving() || controls.session.resting())
  {
    return;
  }
  const auto begin = std::chrono::steady_clock::now();
  send(controls, "step " + std::to_string(steps));
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  const double each = took.count() / steps;
  const double before = controls.milliseconds;
  controls.milliseconds = before == 0 ? each : before + (each - before) / 16;
}

std::string value_text(const Input& input)
{
  switch (input.kind)
  {
  case InputKind::slider:
    return number(input.value.x()) + (input.unit.empty() ? "" : " " + input.unit);
  case InputKind::choice:
    return input.options.empty() ? "" : input.options[std::size_t(input.value.x())];
  case InputKind::toggle:
    return input.value.x() != 0 ? "on" : "off";
  case InputKind::file:
    return input.file.name.empty() ? "drop one here" : input.file.name;
  default:
    return "";
  }
}

std::string motion_text(const Controls& controls)
{
  const Session& session = controls.session;
  if (!session.moving())
  {
    return "";
  }
  return !controls.playing ? "paused" : session.resting() ? "at rest" : "playing";
}

std::vector<std::string> keys_text(const Controls& controls)
{
  std::vector<std::string> keys;
  if (controls.session.moving())
  {
    keys = {"Space pause", ". one step", "R restart"};
  }
  if (!offered(controls.session).empty())
  {
    keys.insert(keys.end(), {"↑ ↓ choose", "← → change", "Enter press"});
  }
  keys.insert(keys.end(), {"S all as at first", "D dark", "Esc close"});
  return keys;
}

int StepClock::due(int most)
{
  int steps = 0;
  const Clock::time_point now = Clock::now();
  for (; next_ <= now && steps < most; ++steps)
  {
    next_ += step;
  }
  next_ = std::max(next_, now);
  return steps;
}

int StepClock::wait() const
{
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(next_ - Clock::now());
  return int(std::clamp<std::chrono::milliseconds::rep>(left.count(), 0, 17));
}

} // namespace cookbook::live
