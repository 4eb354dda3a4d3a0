/// \file
/// A live figure in a terminal: opened in one that is none, by what is typed.

#include "tests/catch.hpp"
#include "tests/window/opened.hpp"

#include "tools/live/hosts/half_blocks.hpp"
#include "tools/live/session.hpp"

#include <cstring>
#include <fcntl.h>
#include <map>
#include <pty.h>
#include <termios.h>
#include <utmp.h>

using namespace cookbook;

namespace
{

constexpr int columns = 100, rows = 40;

/// A terminal that is none, with the figure in it.
class Terminal
{
public:
  Terminal() : program_(opened())
  {
    tcgetattr(slave_, &before_);
    fcntl(master_, F_SETFL, O_NONBLOCK);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal()
  {
    close(master_);
    close(slave_);
  }

  void type(const std::string& text) const
  {
    REQUIRE(::write(master_, text.data(), text.size()) == ssize_t(text.size()));
  }

  /// All that was written until now.
  const std::string& written()
  {
    char bytes[4096];
    for (ssize_t n = ::read(master_, bytes, sizeof bytes); n > 0;
         n = ::read(master_, bytes, sizeof bytes))
    {
      text_.append(bytes, std::size_t(n));
    }
    return text_;
  }

  /// What stands in a line now: what was written there last.
  std::string line(int row)
  {
    const std::string begin = "\x1b[" + std::to_string(row + 1) + ";1H";
    const std::string& all = written();
    const std::size_t at = all.rfind(begin), end = all.find("\x1b[K", at);
    const bool whole = at != all.npos && end != all.npos;
    return whole ? all.substr(at + begin.size(), end - at - begin.size()) : "";
  }

  /// Whether letters are read one by one, and not echoed.
  bool is_raw() const
  {
    termios now{};
    tcgetattr(slave_, &now);
    return (now.c_lflag & tcflag_t(ICANON | ECHO)) == 0;
  }

  /// Whether it is as it was before the program.
  bool is_restored() const
  {
    termios now{};
    tcgetattr(slave_, &now);
    return now.c_lflag == before_.c_lflag && now.c_iflag == before_.c_iflag;
  }

  Process& program() { return program_; }

  /// Reads for a while, as a terminal does: a program whose output stays unread waits.
  void reads(int milliseconds)
  {
    for (int i = 0; i < milliseconds / 10; ++i)
    {
      written();
      pause(10);
    }
  }

  /// What the program ended with, read to its end.
  int ended_with()
  {
    comes_true(
        [&]
        {
          written();
          return !program_.runs();
        });
    return program_.ended_with();
  }

private:
  /// Opens it and starts the program, which waits until its state is known.
  pid_t opened()
  {
    const winsize size{rows, columns, 0, 0};
    openpty(&master_, &slave_, nullptr, nullptr, &size);
    const pid_t id = fork();
    if (id == 0)
    {
      pause(200);
      login_tty(slave_);
      become({SQUARE_LIVE, "--host", "terminal"});
    }
    return id;
  }

  int master_ = -1, slave_ = -1;
  Process program_;
  termios before_{};
  std::string text_;
};

/// Whether the terminal shows the session's pixels, in all lines of the picture: 96 × 30
/// characters, under which ten lines are left.
bool shows(Terminal& terminal, const live::Session& session)
{
  const live::Shown shown{session.picture_width(), session.picture_height(), session.pixels()};
  for (int row = 0; row < 30; ++row)
  {
    if (terminal.line(row) != live::half_block_row(shown, 96, row, 30))
    {
      return false;
    }
  }
  return true;
}

/// The step that the terminal has come to; -1 if it shows none of the first thousand.
int step_shown(Terminal& terminal, live::Session& session)
{
  session.send("reset");
  for (int step = 0; step < 1000; ++step)
  {
    if (shows(terminal, session))
    {
      return step;
    }
    session.send("step 1");
  }
  return -1;
}

/// Whether terminals can be opened here; a root without /dev/pts has none.
bool has_terminals()
{
  int master = -1, slave = -1;
  if (openpty(&master, &slave, nullptr, nullptr, nullptr) != 0)
  {
    WARN("no pseudo-terminal can be opened here: nothing is tried");
    return false;
  }
  close(master);
  close(slave);
  return true;
}

constexpr char leave[] = "\x1b[?1006l\x1b[?1002l\x1b[?25h\x1b[?1049l\x1b[0m";

} // namespace

TEST_CASE("A character has the mean of two cells of a picture as its colours")
{
  const auto grey = [](std::uint8_t r) {
    return std::bit_cast<std::uint32_t>(std::array<std::uint8_t, 4>{r, 7, 9, 255});
  };
  const std::vector<std::uint32_t> pixels{grey(10), grey(20), grey(30), grey(40)};
  const live::Shown shown{2, 2, pixels};
  CHECK(live::half_block_row(shown, 1, 0, 1) == "\x1b[38;2;15;7;9m\x1b[48;2;35;7;9m\u2580\x1b[0m");
  CHECK(
      live::half_block_row(shown, 2, 0, 1) ==
      "\x1b[38;2;10;7;9m\x1b[48;2;30;7;9m\u2580\x1b[38;2;20;7;9m\x1b[48;2;40;7;9m\u2580\x1b[0m");
}

TEST_CASE("A terminal shows a figure's own pixels, does what is typed, and is given back")
{
  if (!has_terminals())
  {
    return;
  }
  Terminal terminal;
  live::Session session(live::figure);
  REQUIRE(comes_true([&] { return terminal.line(29).size() > 96; }));
  CHECK(terminal.is_raw());

  terminal.reads(300); // some steps
  terminal.type(" ");
  terminal.reads(500);
  const int step = step_shown(terminal, session);
  CHECK(step > 0);

  terminal.type("."); // one step
  session.send("step 1");
  CHECK(comes_true([&] { return shows(terminal, session); }));

  terminal.type("\x1b[C\t\x1b[C"); // right, tab, right
  session.send("set size 61\nset colour 1");
  CHECK(comes_true([&] { return shows(terminal, session); }));

  terminal.type("\x1b[<0;49;16M"); // the mouse, in the middle of a character
  session.send("pointer 161.7 103.3 down");
  CHECK(comes_true([&] { return shows(terminal, session); }));

  terminal.type("q");
  CHECK(terminal.ended_with() == 0);
  CHECK(terminal.written().ends_with(leave));
  CHECK(terminal.is_restored());
}

TEST_CASE("A terminal is given back also where a signal ends the program")
{
  if (!has_terminals())
  {
    return;
  }
  for (const int signal : {SIGTERM, SIGHUP, SIGSEGV})
  {
    Terminal terminal;
    REQUIRE(comes_true([&] { return terminal.is_raw(); }));
    terminal.program().kill(signal);
    CHECK(terminal.ended_with() == 128 + signal);
    CHECK(terminal.written().ends_with(leave));
    CHECK(terminal.is_restored());
  }
}

TEST_CASE("Where the output is no terminal there is one picture, and its numbers")
{
  FILE* const pipe = popen(SQUARE_LIVE " --host terminal </dev/null", "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
  {
    text += char(c);
  }
  CHECK(pclose(pipe) == 0);
  live::Session session(live::figure);
  const live::Shown shown{session.picture_width(), session.picture_height(), session.pixels()};
  std::string expected;
  for (int row = 0; row < 25; ++row)
  {
    expected += live::half_block_row(shown, 80, row, 25) + "\n";
  }
  CHECK(text == expected + "left 20 px\n");
}
