/// \file
/// \brief The world, compiled once for programs and tests.

#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"

// [compiled_once]
#define COOKBOOK_WORLD_SOURCE
#include "05_resolution/world/world.hpp"
// [compiled_once]
