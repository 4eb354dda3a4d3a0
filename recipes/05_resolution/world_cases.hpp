#pragma once

/// \file
/// \brief Scenes on which solvers fail, run with each of them; compiled once for program and test.

#include "common/program/verdicts.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The solvers of the table, by name.
const std::vector<std::string>& world_case_solvers();

/// The verdicts: a row for each case, a column for each solver.
std::vector<VerdictRow> world_verdicts();

} // namespace cookbook
