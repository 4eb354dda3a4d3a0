/// \file
/// \brief The step of the world for WebAssembly, with nothing beside it that needs other sources.

#define COOKBOOK_WORLD_SOURCE
#include "06_world/game_world/game_world.hpp"
