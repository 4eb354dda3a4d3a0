#pragma once

/// \file
/// \brief Scenes on which solvers fail, run with each of them; compiled once for program and test.

#include "tools/program/verdicts.hpp"

#include <vector>

namespace cookbook
{

/// The verdicts: a row for each case, a column for each of solver_names().
std::vector<VerdictRow> world_verdicts();

} // namespace cookbook
