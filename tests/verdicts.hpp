#pragma once

/// \file
/// \brief Comparing a table of verdicts with what is expected of each cell.

#include "common/program/verdicts.hpp"

#include "tests/catch.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace cookbook
{

/// Asserts every cell: a row of text for each case, in it + where a method holds, - where it fails,
/// a space where it cannot be asked.
inline void check_verdicts(
    const std::vector<VerdictRow>& rows, const std::vector<std::string>& methods,
    const std::vector<std::string>& expected)
{
  REQUIRE(rows.size() == expected.size());
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    REQUIRE(rows[row].verdicts.size() == expected[row].size());
    for (std::size_t method = 0; method < expected[row].size(); ++method)
    {
      const Verdict& verdict = rows[row].verdicts[method];
      INFO(rows[row].what << ", " << methods.at(method) << ": " << verdict.what);
      CHECK(verdict.holds == (expected[row][method] == '+'));
      CHECK(verdict.applies == (expected[row][method] != ' '));
    }
  }
}

} // namespace cookbook
