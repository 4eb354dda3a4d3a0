#pragma once

/// \file
/// \brief Programs that answer a reader's question for each row of a file.

#include "tools/files/pairs_row.hpp"
#include "tools/program/program.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace cookbook
{

/// What a reader may ask of each row of a file: `--ask NAME --pairs FILE`.
template <class Real>
struct Question
{
  std::string name;    ///< what --ask calls it
  std::string columns; ///< of the file, such as `ax,ay,az`
  std::string answers; ///< of what is printed, after `pair`
  /// A number each; those left out are empty.
  std::function<std::vector<Real>(const PairsRow&)> answer;
};

/// The answers to all rows as CSV: `pair,…`, pairs from zero; cells without an answer are empty.
///
/// The whole file is read first. CsvError at a row whose answer is not finite.
template <class Real>
std::string answers_csv(const Question<Real>& question, const std::string& file)
{
  std::string text = "pair," + question.answers + "\n";
  const auto cells = std::count(question.answers.begin(), question.answers.end(), ',') + 1;
  std::size_t pair = 0;
  for (const CsvRow& row : read_csv(file, question.columns))
  {
    const std::vector<Real> numbers = question.answer({file, question.columns, row});
    text += std::to_string(pair++);
    for (const Real number : numbers)
    {
      if (!std::isfinite(number))
      {
        throw CsvError(file, row.line, 1, "the answer is too large for the number type");
      }
      text += ',';
      text += round_trip(number);
    }
    text.append(static_cast<std::size_t>(cells) - numbers.size(), ',').append("\n");
  }
  return text;
}

/// Runs a program that takes --ask, --pairs and --scalar: `questions(Real())` lists what may be
/// asked; where nothing is, `own(arguments)` prints and draws the chapter's scene.
template <class Questions>
int run_asking_program(
    int argc, char** argv, Arguments arguments, const Questions& questions,
    const std::function<void(const Arguments&)>& own)
{
  std::vector<std::string> names;
  for (const Question<double>& question : questions(0.0))
  {
    arguments.pairs_header +=
        (names.empty() ? "" : "\n") + question.columns + " (for --ask " + question.name + ")";
    names.push_back(question.name);
  }
  arguments.options.push_back({"ask", "what to ask of each row of --pairs", "", names, {"pairs"}});
  arguments.options.push_back(scalar_option());
  const auto print_as = [&](const Arguments& given, auto zero)
  {
    for (const auto& question : questions(zero))
    {
      if (question.name == given.value("ask"))
      {
        std::cout << answers_csv(question, given.pairs.string());
      }
    }
  };
  return run_program(
      argc, argv, std::move(arguments),
      [&](const Arguments& given)
      {
        if (given.pairs.empty())
        {
          return own(given);
        }
        if (given.value("ask").empty())
        {
          throw std::runtime_error("--pairs needs --ask with one of the questions (try --help)");
        }
        given.value("scalar") == "float" ? print_as(given, 0.0f) : print_as(given, 0.0);
      });
}

} // namespace cookbook
