/// \file
/// \brief The solvers of the world, compiled once for all that link cookbook::world.

#include "06_world/game_world/game_world.hpp"

// [solvers_compiled_once]
#include "06_world/game_world/solver_named.hpp"
// [solvers_compiled_once]
