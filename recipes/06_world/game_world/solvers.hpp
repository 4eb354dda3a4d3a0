#pragma once

/// \file
/// \brief A world, and the solvers of this chapter for it, by name.

#include "06_world/contacts/scene.hpp"
#include "06_world/game_world/game_world.hpp"
#include "06_world/game_world/solver_names.hpp"
#if COOKBOOK_WORLD_BODIES
#include "06_world/game_world/solver_named.hpp"
#endif
