#pragma once

/// \file
/// \brief A world, and the solvers of this chapter for it, by name.

#include "05_resolution/contacts/scene.hpp"
#include "05_resolution/world/solver_names.hpp"
#include "05_resolution/world/world.hpp"
#if COOKBOOK_WORLD_BODIES
#include "05_resolution/world/solver_named.hpp"
#endif
