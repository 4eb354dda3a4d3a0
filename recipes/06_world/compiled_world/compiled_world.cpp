/// \file
/// \brief The step of the world, compiled once for all that link cookbook::world.

// [compiled_once]
#define COOKBOOK_WORLD_SOURCE
#include "06_world/game_world/game_world.hpp"
// [compiled_once]
