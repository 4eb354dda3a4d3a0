#pragma once

/// \file
/// \brief Comparing a table of verdicts with what is expected of each cell.

#include "tools/program/verdicts.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// What is expected of a case: the methods that hold; those that cannot be asked; all others fail.
struct ExpectedRow
{
  std::string id; ///< of the case, or its set-up, where it is a neighbour without an id
  std::vector<std::string> hold;
  std::vector<std::string> cannot_be_asked{};
};

/// Whether a name is among others.
inline bool is_among(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Asserts every cell, by the names of case and method: each case is expected once, and each name
/// is one of the methods'.
inline void check_verdicts(
    const std::vector<VerdictRow>& rows, const std::vector<std::string>& methods,
    const std::vector<ExpectedRow>& expected)
{
  REQUIRE(rows.size() == expected.size());
  for (const ExpectedRow& one : expected)
  {
    INFO(one.id);
    for (const std::string& name : one.hold)
    {
      INFO(name);
      REQUIRE(is_among(methods, name));
    }
    const auto is_meant = [&](const VerdictRow& row)
    { return row.id == one.id || row.what == one.id; };
    const auto row = std::find_if(rows.begin(), rows.end(), is_meant);
    REQUIRE(std::count_if(rows.begin(), rows.end(), is_meant) == 1);
    REQUIRE(row->verdicts.size() == methods.size());
    for (std::size_t method = 0; method < methods.size(); ++method)
    {
      const Verdict& verdict = row->verdicts[method];
      INFO(methods[method] << ": " << verdict.what);
      CHECK(verdict.holds == is_among(one.hold, methods[method]));
      CHECK(verdict.applies != is_among(one.cannot_be_asked, methods[method]));
    }
  }
}

} // namespace cookbook
