#pragma once

/// \file
/// \brief What the solvers of this chapter are called.

#include <string>
#include <vector>

namespace cookbook
{

/// The names of all solvers, the recommended one first.
inline std::vector<std::string> solver_names()
{
  return {"direct",        "soft_steps",    "wide_steps", "sequential_impulses",
          "cold_impulses", "position_based"};
}

} // namespace cookbook
