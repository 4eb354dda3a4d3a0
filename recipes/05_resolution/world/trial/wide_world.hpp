#pragma once

/// \file
/// \brief A world under wide steps in registers of any width, compiled once with the solvers.

#include "05_resolution/wide_solver/wide_solver.hpp"
#include "05_resolution/world/world.hpp"

namespace cookbook
{

/// A world under wide steps in these passes.
World wide_world(const Scene& scene, const WidePasses& passes, const SoftSettings& how = {});

} // namespace cookbook
