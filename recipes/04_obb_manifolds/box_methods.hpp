#pragma once

/// \file
/// \brief The methods that the table of failing cases compares, and the table's three parts.

#include "04_obb_manifolds/box_verdicts.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// One part of the table: methods that are judged in the same way.
struct VerdictPart
{
  std::string name;                                                    ///< of its figure
  std::string caption;                                                 ///< above the table
  std::vector<BoxMethod> methods;                                      ///< its columns
  Verdict (*verdict)(const BoxCase&, const std::optional<BoxAnswer>&); ///< on each answer
};

/// The whole table.
std::vector<VerdictPart> verdict_parts();

/// What the methods make of all cases; neighbours such as G9b have no id of their own.
inline std::vector<VerdictRow> verdict_rows(const VerdictPart& part)
{
  std::vector<VerdictRow> rows;
  for (const BoxCase& pair : all_box_cases())
  {
    VerdictRow row{pair.id.back() == 'b' ? "" : pair.id, pair.scene, {}};
    for (const BoxMethod& method : part.methods)
    {
      row.verdicts.push_back(part.verdict(pair, method.answer(pair)));
    }
    rows.push_back(row);
  }
  return rows;
}

/// The names of a part's methods.
inline std::vector<std::string> method_names(const VerdictPart& part)
{
  std::vector<std::string> names;
  for (const BoxMethod& method : part.methods)
  {
    names.push_back(method.name);
  }
  return names;
}

} // namespace cookbook
