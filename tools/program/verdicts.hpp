#pragma once

/// \file
/// \brief Tables of failing cases: which method holds in which case, as a page shows them.

#include <string>
#include <vector>

namespace cookbook
{

/// What became of a method in a case.
struct Verdict
{
  bool holds;          ///< whether the answer is right
  std::string what;    ///< in a few words: how it holds or fails
  bool applies = true; ///< whether the method can be asked; neither holds nor fails otherwise
};

/// Of a method that cannot be asked, and why not.
inline Verdict does_not_apply(const std::string& why)
{
  return {false, "n/a: " + why, false};
}

/// One case: its id in the book, what is set up, and a verdict for each method.
struct VerdictRow
{
  std::string id;                ///< such as C4; empty for a neighbour of the case above it
  std::string what;              ///< the set-up, in a few words
  std::vector<Verdict> verdicts; ///< as many as there are methods
  std::string right{}; ///< the right value, beside the wrong ones; a column where any row has it
};

/// The names of methods, in their order: the columns of a table.
template <class Methods>
std::vector<std::string> names_of(const Methods& methods)
{
  std::vector<std::string> names;
  for (const auto& method : methods)
  {
    names.push_back(method.name);
  }
  return names;
}

/// The table as HTML, for a page to include; each row with an id can be linked to as `case-C4`, or
/// with another mark, for a second table of the same cases on a page.
///
/// Throws std::logic_error where a row has not one verdict for each method.
std::string verdict_table(
    const std::string& caption, const std::vector<std::string>& methods,
    const std::vector<VerdictRow>& rows, const std::string& mark = "case");

/// The same with ten telling rows: those with an id, the first of each pattern of which method
/// holds, then the first of the others. The rest stands in a fold.
std::string folded_verdict_table(
    const std::string& caption, const std::vector<std::string>& methods,
    const std::vector<VerdictRow>& rows, const std::string& mark = "case");

} // namespace cookbook
