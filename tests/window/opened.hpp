/// \file
/// A program that runs beside a test, and a screen without hardware that it is shown on.
#pragma once

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace cookbook
{

/// Waits a little.
inline void pause(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Asks until something holds, for ten seconds at most; whether it came to hold.
template <class Holds>
bool comes_true(const Holds& holds)
{
  for (int i = 0; i < 200; ++i)
  {
    if (holds())
    {
      return true;
    }
    pause(50);
  }
  return false;
}

/// Becomes another program, in a process of its own.
[[noreturn]] inline void become(std::vector<std::string> words)
{
  std::vector<char*> argv;
  for (std::string& word : words)
  {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

/// A process, ended at the latest with the test.
class Process
{
public:
  explicit Process(pid_t id) : id_(id) {}
  explicit Process(const std::vector<std::string>& words) : id_(fork())
  {
    if (id_ == 0)
    {
      become(words);
    }
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process()
  {
    if (runs())
    {
      kill(SIGKILL);
      waitpid(id_, &status_, 0);
    }
  }

  void kill(int signal) const { ::kill(id_, signal); }

  /// Whether it has not ended yet.
  bool runs()
  {
    ended_ = ended_ || waitpid(id_, &status_, WNOHANG) == id_;
    return !ended_;
  }

  /// What it ended with: its exit status, or 128 and the signal; -1 while it runs.
  int ended_with()
  {
    if (!comes_true([&] { return !runs(); }))
    {
      return -1;
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }

private:
  pid_t id_;
  int status_ = 0;
  bool ended_ = false;
};

/// Red, green and blue of a pixel.
using Rgb = std::array<int, 3>;

/// What is seen on a screen.
struct Seen
{
  int width = 0, height = 0;
  std::vector<Rgb> pixels;

  const Rgb& at(int x, int y) const { return pixels[std::size_t(y * width + x)]; }
};

/// An X server without hardware: DISPLAY names it, and its memory is a file.
class Screen
{
public:
  Screen(int width, int height)
      : folder_(std::filesystem::temp_directory_path() / ("screen" + std::to_string(getpid()))),
        server_(started(folder_, width, height))
  {
    std::string display;
    const auto named = [&] { return bool(std::ifstream(folder_ / "display") >> display); };
    if (!comes_true(named))
    {
      throw std::runtime_error("Xvfb does not come up");
    }
    setenv("DISPLAY", (":" + display).c_str(), 1);
  }
  ~Screen()
  {
    unsetenv("DISPLAY");
    server_.kill(SIGTERM);
    server_.ended_with();
    std::filesystem::remove_all(folder_);
  }

  /// The screen as it is now: an X window dump in the server's memory.
  Seen seen() const
  {
    std::ifstream file(folder_ / "Xvfb_screen0", std::ios::binary);
    std::array<std::uint32_t, 25> head{};
    for (std::uint32_t& word : head)
    {
      for (int i = 0; i < 4; ++i)
      {
        word = word << 8U | std::uint32_t(file.get() & 0xFF);
      }
    }
    const int width = int(head[4]), height = int(head[5]);
    file.seekg(std::streamoff(head[0] + 12 * head[19]));
    std::vector<char> bytes(4 * std::size_t(width) * std::size_t(height));
    file.read(bytes.data(), std::streamsize(bytes.size()));
    Seen seen{width, height, {}};
    for (std::size_t i = 0; i < bytes.size(); i += 4) // blue, green, red, and a byte of nothing
    {
      seen.pixels.push_back({bytes[i + 2] & 0xFF, bytes[i + 1] & 0xFF, bytes[i] & 0xFF});
    }
    return seen;
  }

private:
  static pid_t started(const std::filesystem::path& folder, int width, int height)
  {
    std::filesystem::create_directories(folder);
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    const pid_t id = fork();
    if (id == 0)
    {
      become(
          {"sh", "-c",
           "exec Xvfb -displayfd 3 -nolisten tcp -screen 0 " + size + " -fbdir " + folder.string() +
               " 3>" + (folder / "display").string() + " 2>/dev/null"});
    }
    return id;
  }

  std::filesystem::path folder_;
  Process server_;
};

} // namespace cookbook
