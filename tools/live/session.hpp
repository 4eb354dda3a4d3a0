#pragma once

/// \file
/// \brief A live figure as a host sees it: events go in as lines of text, its outputs come out.

#include "tools/live/page.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cookbook::live
{

/// A live figure while it is looked at.
///
/// Events are lines of text:
///
///     set NAME X [Y]        a slider, choice (its index), toggle (0 or 1) or handle gets a value
///     drag NAME PX PY       a handle is dragged to a pixel of the figure
///     press NAME            a button
///     file NAME FILE TEXT   a file is opened: its name and text, with %20 for a space
///     pointer PX PY WHAT [WHEEL]   the mouse or a finger in the picture: down, up or move
///     step N                N steps of 1/60 s
///     reset                 the motion begins anew; the inputs stay
///     start                 all inputs as at first, and the motion begins anew
///     theme light|dark
///     width PIXELS
///     restore STATE         what `state()` returned
///
/// A name in an event has `_` for each space. An event that says nothing known throws
/// std::invalid_argument and changes nothing.
class Session
{
public:
  /// Draws the figure for the first time.
  explicit Session(std::function<void(Page&)> figure);

  /// Carries out one event or several, a line each.
  void send(const std::string& events);

  /// All outputs as JSON: inputs, numbers, svg, plots, picture, moving, resting, step, state, code.
  std::string json() const;

  /// The numbers as lines of text: name, value, unit.
  std::string numbers() const;

  /// The state, for a link: the inputs that are not as at first, and what was done at which step.
  std::string state() const;

  /// Ten poses that try every input, each a text of events; the same ones in each host.
  std::vector<std::string> tour() const;

  /// The curves as charts of the book's own, `width` pixels wide; empty where there are none.
  std::string curves_svg(double width) const;

  /// What the figure asked for and showed.
  const std::vector<Input>& inputs() const { return page_.inputs_; }
  const std::vector<Reading>& readings() const { return page_.readings_; }
  const std::vector<Curve>& curves() const { return page_.curves_; }
  const std::string& svg() const { return page_.svg_; }
  std::span<const std::uint32_t> pixels() const { return page_.pixels_; }
  int picture_width() const { return page_.picture_width_; }
  int picture_height() const { return page_.picture_height_; }
  bool moving() const { return page_.moving_; }
  bool resting() const { return page_.resting_; }
  long step() const { return page_.step_; }

private:
  void one(const std::string& event);
  void point(const std::vector<std::string>& words, const std::string& event);
  void set(Input& input, const Eigen::Vector2d& value);
  void open(const std::string& name, const File& file);
  void remember(const std::string& event);
  void restore(const std::string& state);
  void call();
  Input& input(const std::string& name);

  struct Done
  {
    long step;
    std::string event;
  };
  std::function<void(Page&)> figure_;
  Page page_;
  std::string base_;      ///< the inputs when the motion began
  std::vector<Done> log_; ///< since the motion began
};

/// The name of an input as it stands in an event.
std::string event_name(std::string name);

/// The event by which a file is opened.
std::string file_event(const std::string& input, const File& file);

} // namespace cookbook::live
