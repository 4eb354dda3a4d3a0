#include "tools/program/program.hpp"

#include "tools/files/whole_file.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace cookbook
{

const std::string& Arguments::value(const std::string& option) const
{
  for (const Option& candidate : options)
  {
    if (candidate.name == option)
    {
      return candidate.value;
    }
  }
  throw std::logic_error(name + " has no option --" + option);
}

namespace
{

/// Holds back standard output until the program has succeeded.
class HeldOutput
{
public:
  HeldOutput() : real_(std::cout.rdbuf(held_.rdbuf())) {}
  ~HeldOutput() { std::cout.rdbuf(real_); }
  HeldOutput(const HeldOutput&) = delete;
  HeldOutput& operator=(const HeldOutput&) = delete;

  void release()
  {
    std::cout.rdbuf(real_);
    std::cout << held_.str() << std::flush;
    if (!std::cout)
    {
      throw std::runtime_error("cannot write to standard output");
    }
  }

private:
  std::ostringstream held_;
  std::streambuf* real_;
};

void describe(CLI::App& app, Arguments& arguments)
{
  app.add_option("--out", arguments.out, "folder for the figures, made if missing")
      ->capture_default_str()
      ->type_name("FOLDER");
  if (!arguments.pairs_header.empty())
  {
    app.add_option(
           "--pairs", arguments.pairs,
           "your own pairs: a CSV file that begins with the line\n" + arguments.pairs_header)
        ->type_name("FILE")
        ->check([](const std::string& file)
                { return file.empty() ? std::string("the file's name is empty") : std::string(); });
  }
  for (Option& option : arguments.options)
  {
    if (option.choices.size() == 1)
    {
      app.add_flag_callback(
          "--" + option.name, [&option] { option.value = option.choices[0]; }, option.help);
      continue;
    }
    CLI::Option* added = app.add_option("--" + option.name, option.value, option.help);
    added->capture_default_str();
    if (!option.choices.empty())
    {
      added->check(CLI::IsMember(option.choices));
    }
  }
}

/// What is wrong with options given together; empty: nothing.
std::string wrong_together(const CLI::App& app, const Arguments& arguments)
{
  const auto given = [&app](const std::string& name) { return app.count("--" + name) != 0; };
  for (const Option& option : arguments.options)
  {
    if (!given(option.name))
    {
      continue;
    }
    if (!option.needs.empty() && std::none_of(option.needs.begin(), option.needs.end(), given))
    {
      std::string needed;
      for (const std::string& name : option.needs)
      {
        needed += (needed.empty() ? "--" : " or --") + name;
      }
      return "--" + option.name + " would be ignored without " + needed;
    }
    for (const std::string& other : option.excludes)
    {
      if (given(other))
      {
        return "--" + other + " would be ignored beside --" + option.name + "; give one of them";
      }
    }
  }
  return "";
}

/// Whether figures are expected: not where pairs are printed, unless a folder is named for them.
bool draws_figures(const CLI::App& app, const Arguments& arguments)
{
  const auto prints_instead = [&app](const Option& option)
  { return !option.draws && app.count("--" + option.name) != 0; };
  return app.count("--out") != 0 ||
         (arguments.pairs.empty() &&
          std::none_of(arguments.options.begin(), arguments.options.end(), prints_instead));
}

/// Tries the places that the program will write to; throws std::runtime_error.
void check_places(const Arguments& arguments, bool draws)
{
  if (draws)
  {
    check_place(arguments.out / (arguments.name + ".svg"));
  }
  for (const Option& written : arguments.options)
  {
    if (written.file != FileUse::written || written.value.empty())
    {
      continue;
    }
    const auto refuse_if_read = [&](const std::string& name, const std::filesystem::path& file)
    {
      std::error_code not_there;
      if (std::filesystem::equivalent(written.value, file, not_there))
      {
        throw std::runtime_error(
            "--" + written.name + " would overwrite what --" + name + " reads");
      }
    };
    refuse_if_read("pairs", arguments.pairs);
    for (const Option& read : arguments.options)
    {
      if (read.file == FileUse::read)
      {
        refuse_if_read(read.name, read.value);
      }
    }
    check_place(written.value);
  }
}

int run_body(
    const Arguments& arguments, bool draws, const std::function<void(const Arguments&)>& body)
{
  try
  {
    check_places(arguments, draws);
    HeldOutput output;
    body(arguments);
    output.release();
    return 0;
  }
  catch (const WrongOption& error)
  {
    std::cerr << arguments.name << ": error: " << error.what() << '\n';
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << arguments.name << ": error: " << error.what() << '\n';
    return 1;
  }
}

} // namespace

int run_program(
    int argc, char** argv, Arguments arguments, const std::function<void(const Arguments&)>& body)
{
  CLI::App app{arguments.summary, arguments.name};
  arguments.out = ".";
  describe(app, arguments);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& request)
  {
    return app.exit(request);
  }
  catch (const CLI::ParseError& error)
  {
    std::cerr << arguments.name << ": error: " << error.what() << " (try --help)\n";
    return 2;
  }
  if (const std::string wrong = wrong_together(app, arguments); !wrong.empty())
  {
    std::cerr << arguments.name << ": error: " << wrong << " (try --help)\n";
    return 2;
  }
  return run_body(arguments, draws_figures(app, arguments), body);
}

void save_figure(const Arguments& arguments, const std::string& figure, const std::string& content)
{
  const std::filesystem::path path = arguments.out / figure;
  save_whole(path, content);
  std::cerr << "figure: " << path.string() << '\n';
}

Progress::Progress(std::string what, std::size_t total)
    : what_(std::move(what)), total_(total), watched_(isatty(STDERR_FILENO) != 0)
{
}

Progress::~Progress()
{
  if (watched_ && shown_ != 0)
  {
    std::fputs("\r\033[K", stderr);
  }
}

void Progress::at(std::size_t done)
{
  const std::size_t percent = total_ == 0 ? 100 : done * 100 / total_;
  if (watched_ && percent != shown_)
  {
    shown_ = percent;
    std::fprintf(stderr, "\r%s: %zu %%", what_.c_str(), percent);
    std::fflush(stderr);
  }
}

} // namespace cookbook
