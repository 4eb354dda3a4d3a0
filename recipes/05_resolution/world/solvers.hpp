#pragma once

/// \file
/// \brief A world, and the solvers of this chapter for it, by name.

#include "05_resolution/world/solver_names.hpp"
#include "05_resolution/world/world.hpp"
#if COOKBOOK_WORLD_BODIES
#include "05_resolution/world/solver_named.hpp"
#endif

#include <string>

namespace cookbook
{

/// A solver by name, with so many substeps, or what it takes itself if that is 0.
///
/// std::invalid_argument if there is no such name, or the substeps are negative.
COOKBOOK_WORLD_INLINE IslandSolver solver_named(const std::string& name, int substeps = 0);

} // namespace cookbook
