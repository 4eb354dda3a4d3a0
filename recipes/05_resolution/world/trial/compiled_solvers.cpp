/// \file
/// \brief The solvers of the world, compiled once for programs and tests.

#include "04_obb_manifolds/box_judges/trial/box_instances.hpp"

// [solvers_compiled_once]
#include "05_resolution/world/solver_named.hpp"
// [solvers_compiled_once]
