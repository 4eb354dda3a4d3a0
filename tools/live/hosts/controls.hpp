#pragma once

/// \file
/// \brief What a window and a terminal have in common: keys, the clock of the steps, inputs as
/// text.

#include "tools/live/session.hpp"

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace cookbook::live
{

/// A live figure under a keyboard: which input is chosen, whether it plays.
struct Controls
{
  Session& session;
  std::size_t chosen = 0;  ///< which of the inputs that are offered
  bool playing = true;     ///< steps are made by the clock
  bool closed = false;     ///< the reader has closed it
  bool dark = false;       ///< its theme
  double milliseconds = 0; ///< what a step took, smoothed, with its picture
  std::string message{};   ///< why the last event was refused; empty where it was not
};

/// Sends events; keeps the message of what they throw.
void send(Controls& controls, const std::string& events);

/// Opens a file that was dropped on the figure, where it asks for one.
void open_file(Controls& controls, const std::filesystem::path& path);

/// The inputs that the figure asks for now, but for handles, which belong to drawings.
std::vector<Input> offered(const Session& session);

/// Does what a key means: "space", "tab", "up", "down", "left", "right", "enter", "escape", or a
/// letter or sign.
void press_key(Controls& controls, const std::string& key);

/// Changes an input by so many steps: a hundredth of a slider, one option of a choice; a toggle is
/// turned over.
void change(Controls& controls, const Input& input, int by);

/// Makes steps, where the figure plays and does not rest, and measures them.
void advance(Controls& controls, int steps);

/// The value of an input as a reader has it.
std::string value_text(const Input& input);

/// "playing", "paused", or "at rest"; empty where nothing moves.
std::string motion_text(const Controls& controls);

/// What the keys do, in a few words each.
std::vector<std::string> keys_text(const Controls& controls);

/// Ends with an error for a figure that shows no picture.
void need_picture(const std::string& name, const Session& session);

/// How many steps of 1/60 s are due by the clock.
class StepClock
{
public:
  /// The steps since the last call, at most `most`: where the machine is slower, time is let go.
  int due(int most);

  /// Until the next step [ms].
  int wait() const;

private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::nanoseconds step{1'000'000'000 / 60};
  Clock::time_point next_ = Clock::now() + step;
};

/// Shows a figure in a window until it is closed.
void run_window(const std::string& name, Session& session);

/// Shows a figure in the terminal until it is closed; where standard output is none, one picture.
void run_terminal(const std::string& name, Session& session);

} // namespace cookbook::live
