/// \file
/// A live figure in a window: opened on a screen without hardware, by keys and a mouse that are
/// none.

#include "tests/catch.hpp"
#include "tests/window/opened.hpp"

#include "tools/live/session.hpp"

#include <bit>
#include <cmath>

using namespace cookbook;

namespace
{

/// The left upper corner of what is not black.
std::pair<int, int> corner(const Seen& seen)
{
  for (int y = 0; y < seen.height; ++y)
  {
    for (int x = 0; x < seen.width; ++x)
    {
      if (seen.at(x, y) != Rgb{0, 0, 0})
      {
        return {x, y};
      }
    }
  }
  return {-1, -1};
}

/// How far what is seen is from the session's pixels, in the mean of channels from 0 to 255.
double difference(const Seen& seen, const live::Session& session)
{
  const auto [left, top] = corner(seen);
  const int width = session.picture_width(), height = session.picture_height();
  if (left < 0 || left + width > seen.width || top + height > seen.height)
  {
    return 255;
  }
  double sum = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const std::uint32_t pixel = session.pixels()[std::size_t(y * width + x)];
      const auto own = std::bit_cast<std::array<std::uint8_t, 4>>(pixel);
      const Rgb& shown = seen.at(left + x, top + y);
      for (std::size_t i = 0; i < 3; ++i)
      {
        sum += std::abs(shown[i] - own[i]);
      }
    }
  }
  return sum / (3.0 * width * height);
}

/// A key or the mouse, by xdotool's words.
void input(const std::string& words)
{
  REQUIRE(std::system(("xdotool " + words).c_str()) == 0);
}

/// Whether the screen comes to show the session's pixels; no step of the square, and no pixel more
/// or less of its size, stays below this difference.
bool comes_to_show(const Screen& screen, const live::Session& session)
{
  return comes_true([&] { return difference(screen.seen(), session) < 0.05; });
}

/// A place in the window, as xdotool has it.
std::string at(const Seen& seen, int x, int y)
{
  const auto [left, top] = corner(seen);
  return std::to_string(left + x) + " " + std::to_string(top + y);
}

/// The step that the window has come to and stays at; -1 if it shows none of the first thousand.
int step_shown(const Screen& screen, live::Session& session)
{
  const Seen seen = screen.seen();
  session.send("reset");
  for (int step = 0; step < 1000; ++step)
  {
    if (difference(seen, session) < 0.05)
    {
      return step;
    }
    session.send("step 1");
  }
  return -1;
}

} // namespace

TEST_CASE(
    "A window shows a figure's own pixels, does what keys and the mouse say, and closes",
    "[window]")
{
  const Screen screen(640, 480);
  Process window({SQUARE_LIVE, "--host", "window"});
  live::Session session(live::figure);
  REQUIRE(comes_true([&] { return corner(screen.seen()).first >= 0; }));
  input("mousemove 320 240");

  input("key space"); // paused
  pause(500);
  const int step = step_shown(screen, session);
  CHECK(step > 0);
  pause(300);
  CHECK(step_shown(screen, session) == step);

  input("key period"); // one step
  session.send("step 1");
  CHECK(comes_to_show(screen, session));

  input("key Right"); // the first input, a slider, by a hundredth
  session.send("set size 61");
  CHECK(comes_to_show(screen, session));

  input("key Tab Right"); // the second, a choice
  session.send("set colour 1");
  CHECK(comes_to_show(screen, session));

  input("mousemove " + at(screen.seen(), 200, 120) + " mousedown 1");
  session.send("pointer 200 120 down");
  CHECK(comes_to_show(screen, session));
  input("mousemove " + at(screen.seen(), 230, 100));
  session.send("pointer 230 100 move");
  CHECK(comes_to_show(screen, session));
  input("mouseup 1");
  session.send("pointer 230 100 up");

  input("mousemove " + at(screen.seen(), 360, 150) + " click 1"); // in the panel: jump
  session.send("press jump");
  CHECK(comes_to_show(screen, session));

  input("key d");
  session.send("theme dark");
  CHECK(comes_to_show(screen, session));

  input("key Escape");
  CHECK(window.ended_with() == 0);
}

TEST_CASE("A window makes its steps by the clock, at most 60 in a second", "[window]")
{
  const Screen screen(640, 480);
  Process window({SQUARE_LIVE, "--host", "window"});
  live::Session session(live::figure);
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  REQUIRE(comes_true([&] { return corner(screen.seen()).first >= 0; }));
  input("mousemove 320 240");
  pause(2000);
  input("key space");
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  pause(300);
  const int steps = step_shown(screen, session);
  CHECK(steps <= 60 * seconds + 20); // those of the pause after the key at most
  CHECK(steps >= 30);                // also where others keep the machine busy
  window.kill(SIGKILL);
}

TEST_CASE("Without a screen a window is an error that says what to do", "[window]")
{
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  FILE* const pipe = popen(SQUARE_LIVE " --host window 2>&1 </dev/null", "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
  {
    text += char(c);
  }
  CHECK(WEXITSTATUS(pclose(pipe)) == 1);
  CHECK_THAT(text, Catch::Matchers::ContainsSubstring("no window can be opened here"));
  CHECK_THAT(text, Catch::Matchers::ContainsSubstring("--terminal"));
}
