#pragma once

/// \file
/// \brief What the ways to carry a plane along, and to see a point in a body's frame, come to.

#include "tools/program/verdicts.hpp"

#include <string>
#include <vector>

namespace cookbook
{

/// The names of all ways to carry a plane along, and the verdicts on them.
std::vector<std::string> plane_names();
std::vector<VerdictRow> plane_verdicts();

/// The names of all ways to a body's frame, and the verdicts on them.
std::vector<std::string> local_names();
std::vector<VerdictRow> local_verdicts();

} // namespace cookbook
