/// \file
/// \brief The solvers of the world for WebAssembly.

#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solver_named.hpp"
