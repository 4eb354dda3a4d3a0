#include "tools/live/hosts/controls.hpp"
#include "tools/live/hosts/half_blocks.hpp"

#include <csignal>
#include <iostream>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace cookbook::live
{

namespace
{

// The alternate screen, no cursor, the mouse told in characters; and back again.
constexpr char enter[] = "\x1b[?1049h\x1b[?25l\x1b[?1002h\x1b[?1006h\x1b[2J";
constexpr char leave[] = "\x1b[?1006l\x1b[?1002l\x1b[?25h\x1b[?1049l\x1b[0m";

termios before_us; ///< as the terminal was, for the handler of signals

/// Writes all of a text to the terminal, past the streams that a program's output waits in.
void put(const char* text, std::size_t length)
{
  while (length > 0)
  {
    const ssize_t written = ::write(STDOUT_FILENO, text, length);
    if (written <= 0)
    {
      return;
    }
    text += written;
    length -= std::size_t(written);
  }
}

/// Gives the terminal back as it was; calls nothing that a handler of signals may not.
void restore_terminal()
{
  put(leave, sizeof leave - 1);
  tcsetattr(STDIN_FILENO, TCSANOW, &before_us);
}

/// Gives the terminal back, then lets the signal do what it does.
void on_signal(int signal)
{
  restore_terminal();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// A terminal without lines and echo, while it lives.
struct RawTerminal
{
  RawTerminal()
  {
    tcgetattr(STDIN_FILENO, &before_us);
    for (const int signal : signals)
    {
      std::signal(signal, on_signal);
    }
    termios raw = before_us;
    raw.c_lflag &= ~tcflag_t(ICANON | ECHO | ISIG | IEXTEN);
    raw.c_iflag &= ~tcflag_t(IXON | ICRNL);
    raw.c_cc[VMIN] = 0;
    raw.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    put(enter, sizeof enter - 1);
  }
  RawTerminal(const RawTerminal&) = delete;
  RawTerminal& operator=(const RawTerminal&) = delete;
  ~RawTerminal()
  {
    restore_terminal();
    for (const int signal : signals)
    {
      std::signal(signal, SIG_DFL);
    }
  }

  static constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGFPE};
};

/// Where things stand in the terminal, in characters.
struct Layout
{
  int columns = 80, rows = 24;                 ///< of the terminal
  int picture_columns = 80, picture_rows = 24; ///< of the picture in it
  bool operator==(const Layout&) const = default;
};

/// A picture as large as `columns` and `rows` allow, under which `below` lines stand.
Layout lay_out(const Session& session, int columns, int rows, int below)
{
  const double ratio = double(session.picture_height()) / session.picture_width() / 2;
  Layout layout{columns, rows, 0, 0};
  const int most = std::max(rows - below, 1);
  layout.picture_columns = std::max(1, std::min(columns, int(most / ratio)));
  layout.picture_rows = std::clamp(int(layout.picture_columns * ratio + 0.5), 1, most);
  return layout;
}

/// The size of the terminal; 80 × 24 where it does not say.
std::pair<int, int> terminal_size()
{
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? std::pair<int, int>(size.ws_col, size.ws_row) : std::pair<int, int>(80, 24);
}

/// How many characters of a line are seen: of UTF-8, without bytes that go on.
int length_of(const std::string& text)
{
  return int(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Parts in lines of at most `columns` characters, of which at most `most` are kept.
std::vector<std::string> wrapped(const std::vector<std::string>& parts, int columns, int most)
{
  std::vector<std::string> lines;
  for (const std::string& part : parts)
  {
    if (!lines.empty() && length_of(lines.back()) + 3 + length_of(part) <= columns)
    {
      lines.back() += "   " + part;
    }
    else
    {
      lines.push_back(part);
    }
  }
  lines.resize(std::min(lines.size(), std::size_t(most)));
  return lines;
}

/// What stands below the picture: the motion, the input that is chosen, numbers, keys.
std::vector<std::string> lines_below(const Controls& controls, int columns)
{
  const Session& session = controls.session;
  std::vector<std::string> parts;
  if (session.moving())
  {
    parts = {motion_text(controls), "step " + std::to_string(session.step())};
  }
  const std::vector<Input> inputs = offered(session);
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const std::string text = inputs[i].name + " " + value_text(inputs[i]);
    parts.push_back(i == controls.chosen ? "[" + text + "]" : text);
  }
  std::vector<std::string> lines = wrapped(parts, columns, 4), numbers;
  for (const Reading& one : session.readings())
  {
    numbers.push_back(one.name + ": " + one.value + (one.unit.empty() ? "" : " " + one.unit));
  }
  for (const auto& more :
       {wrapped(numbers, columns, 3), wrapped(keys_text(controls), columns, 2),
        std::vector<std::string>(controls.message.empty() ? 0 : 1, controls.message)})
  {
    lines.insert(lines.end(), more.begin(), more.end());
  }
  return lines;
}

/// The lines of the whole screen.
std::vector<std::string> screen_lines(const Session& session, const Layout& layout)
{
  const Shown shown{session.picture_width(), session.picture_height(), session.pixels()};
  std::vector<std::string> lines;
  for (int row = 0; row < layout.picture_rows; ++row)
  {
    lines.push_back(half_block_row(shown, layout.picture_columns, row, layout.picture_rows));
  }
  return lines;
}

/// A terminal that shows a figure: what stands in it, and what was typed and not read yet.
class Terminal
{
public:
  explicit Terminal(Controls& controls) : controls_(controls) {}

  /// Writes the lines that have changed.
  void draw()
  {
    const auto [columns, rows] = terminal_size();
    const std::vector<std::string> below = lines_below(controls_, columns);
    const Layout layout = lay_out(controls_.session, columns, rows, 10);
    std::vector<std::string> lines = screen_lines(controls_.session, layout);
    lines.insert(lines.end(), below.begin(), below.end());
    lines.resize(std::size_t(rows));
    std::string text = layout == layout_ ? "" : "\x1b[2J";
    last_.resize(layout == layout_ ? last_.size() : 0);
    last_.resize(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      if (lines[i] != last_[i])
      {
        text += "\x1b[" + std::to_string(i + 1) + ";1H" + lines[i] + "\x1b[K";
      }
    }
    put(text.data(), text.size());
    layout_ = layout;
    last_ = lines;
  }

  /// Reads what is typed within a time, and does it.
  void read(int milliseconds)
  {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, milliseconds) <= 0)
    {
      return;
    }
    char bytes[256];
    const ssize_t count = ::read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) // the other end is gone
    {
      controls_.closed = true;
      return;
    }
    typed_.append(bytes, std::size_t(count));
    while (!typed_.empty() && !controls_.closed)
    {
      take();
    }
  }

private:
  /// Does the first key, or what the mouse did, of what was typed.
  void take()
  {
    int button = 0, column = 0, row = 0, length = 0;
    char end = 0;
    if (std::sscanf(typed_.c_str(), "\x1b[<%d;%d;%d%c%n", &button, &column, &row, &end, &length) ==
            4 &&
        length > 0)
    {
      typed_.erase(0, std::size_t(length));
      point(button, column, row, end == 'M');
      return;
    }
    if (typed_.size() > 2 && typed_[0] == '\x1b' && (typed_[1] == '[' || typed_[1] == 'O'))
    {
      const std::string arrows = "ABCD";
      const char* const names[] = {"up", "down", "right", "left"};
      const std::size_t which = arrows.find(typed_[2]);
      typed_.erase(0, 3);
      press_key(controls_, which == arrows.npos ? "" : names[which]);
      return;
    }
    const char c = char(std::tolower(static_cast<unsigned char>(typed_[0])));
    typed_.erase(0, 1);
    press_key(
        controls_, c == '\x1b' || c == 3 ? "escape"
                   : c == '\t'           ? "tab"
                   : c == '\r'           ? "enter"
                   : c == ' '            ? "space"
                                         : std::string(1, c));
  }

  /// The mouse: `button` is 0 to 2, with 32 while it moves; 64 and 65 are the wheel.
  void point(int button, int column, int row, bool down)
  {
    if (row > layout_.picture_rows && !(button & 32))
    {
      return;
    }
    const double width = controls_.session.picture_width();
    const double height = controls_.session.picture_height();
    const double x = (column - 0.5) * width / layout_.picture_columns;
    const double y = std::min((row - 0.5) * height / layout_.picture_rows, height);
    const char* const what = button >= 32 ? "move" : down ? "down" : "up";
    const char* const wheel = button == 64 ? " 1" : button == 65 ? " -1" : "";
    char text[96];
    std::snprintf(text, sizeof text, "pointer %.1f %.1f %s%s", x, y, what, wheel);
    send(controls_, text);
  }

  Controls& controls_;
  Layout layout_{0, 0, 0, 0};
  std::vector<std::string> last_;
  std::string typed_;
};

/// One picture and the numbers, for a file or a pipe.
void print_once(const Session& session)
{
  for (const std::string& line : screen_lines(session, lay_out(session, 80, 1000, 0)))
  {
    std::cout << line << "\n";
  }
  std::cout << session.numbers();
}

} // namespace

void run_terminal(const std::string&, Session& session)
{
  if (isatty(STDOUT_FILENO) == 0 || isatty(STDIN_FILENO) == 0)
  {
    print_once(session);
    return;
  }
  Controls controls{session};
  const RawTerminal raw;
  Terminal terminal(controls);
  StepClock clock;
  for (int frame = 0; !controls.closed; ++frame)
  {
    advance(controls, clock.due(6));
    if (frame % 2 == 0) // what is written takes longer than what is computed
    {
      terminal.draw();
    }
    terminal.read(std::max(clock.wait(), 1));
  }
}

} // namespace cookbook::live
