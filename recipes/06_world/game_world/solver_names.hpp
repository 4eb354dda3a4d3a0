#pragma once

/// \file
/// \brief What the solvers of this chapter are called.

#include "06_world/game_world/compiled_once.hpp"
#include "06_world/islands/world_solver.hpp"
#include "06_world/soft_steps/soft_settings.hpp"

#include <string>
#include <vector>

namespace cookbook
{

struct WidePasses;

/// The names of all solvers, the recommended one first.
inline std::vector<std::string> solver_names()
{
  return {"direct",        "soft_steps",    "wide_steps", "sequential_impulses",
          "cold_impulses", "position_based"};
}

/// A solver by name, with so many substeps, or what it takes itself if that is 0.
///
/// std::invalid_argument if there is no such name, or the substeps are negative.
COOKBOOK_WORLD_INLINE WorldSolver solver_named(const std::string& name, int substeps = 0);

/// Soft steps with settings of one's own.
COOKBOOK_WORLD_INLINE WorldSolver soft_solver(const SoftSettings& how);

/// Wide steps with settings of one's own, by these passes, such as widest_passes().
COOKBOOK_WORLD_INLINE WorldSolver wide_solver(const SoftSettings& how, const WidePasses& passes);

} // namespace cookbook
