#pragma once

/// \file
/// \brief What every recipe's program has in common: arguments, errors, figures, progress.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace cookbook
{

/// What becomes of the file that an option names.
enum class FileUse
{
  none,   ///< the option names no file
  read,   ///< it is read
  written ///< it is written
};

/// One further option of a program, `--name VALUE`; or only `--name`, where there is one choice.
struct Option
{
  std::string name;                 ///< without the dashes
  std::string help;                 ///< one sentence
  std::string value;                ///< the default; afterwards what the reader chose
  std::vector<std::string> choices; ///< the values allowed; empty: any

  std::vector<std::string> needs{};    ///< options: without any of them this one would be ignored
  std::vector<std::string> excludes{}; ///< options that would be ignored beside this one
  FileUse file = FileUse::none;        ///< what becomes of the file that it names
  bool draws = true;                   ///< whether figures are drawn where it is given
};

/// The option with which a reader chooses the number type of --pairs.
inline Option scalar_option()
{
  return {"scalar", "number type for --pairs", "double", {"float", "double"}, {"pairs"}};
}

/// The option with which a chart is measured at length or quickly.
inline Option effort_option()
{
  return {"effort", "how long to measure", "full", {"full", "quick"}};
}

/// What a program is called with, and what it can be called with.
struct Arguments
{
  std::string name;              ///< of the program
  std::string summary;           ///< one sentence: what it prints and draws
  std::string pairs_header{};    ///< columns of the file that --pairs reads; empty: no such option
  std::vector<Option> options{}; ///< further options
  std::filesystem::path out{};   ///< folder for figures
  std::filesystem::path pairs{}; ///< the reader's own data; empty: the chapter's scene

  /// The value of the option called `option`; std::logic_error if the program has none such.
  const std::string& value(const std::string& option) const;
};

/// What a program throws where an option is wrong: it then ends with 2, as for all wrong options.
struct WrongOption : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Runs a program: reads its arguments, then calls `body` with them.
///
/// Returns the exit status: 0, 1 where `body` throws (its sentence goes to standard error), 2 for
/// wrong arguments. Standard output is written only when `body` has come to its end. Before `body`
/// begins, the places are tried that it will write to: `--out`, and the files of options; a file
/// that is also read is refused.
int run_program(
    int argc, char** argv, Arguments arguments, const std::function<void(const Arguments&)>& body);

/// Writes `<out>/<figure>`, whole or not at all, and says so on standard error; throws
/// std::runtime_error if it cannot.
void save_figure(const Arguments& arguments, const std::string& figure, const std::string& content);

/// A line on standard error that counts up while long work goes on; silent unless a person watches.
class Progress
{
public:
  /// Begins to count to `total`.
  Progress(std::string what, std::size_t total);
  /// Removes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Says that `done` of the total is done.
  void at(std::size_t done);

private:
  std::string what_;
  std::size_t total_;
  std::size_t shown_ = 0;
  bool watched_;
};

} // namespace cookbook
