/// \file
/// \brief The world and its solvers, compiled once for programs and tests.

#include "04_obb_manifolds/box_judges/trial/box_instances.hpp"

// [compiled_once]
#define COOKBOOK_WORLD_SOURCE
#include "05_resolution/world/solvers.hpp"
// [compiled_once]
