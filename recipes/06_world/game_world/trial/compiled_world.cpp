/// \file
/// \brief The world, compiled once for programs and tests.

#include "04_obb_manifolds/box_oracles/trial/box_instances.hpp"

// [compiled_once]
#define COOKBOOK_WORLD_SOURCE
#include "06_world/game_world/game_world.hpp"
// [compiled_once]
