#pragma once

/// \file
/// \brief All modules of a world for a game.

#include "06_world/game_world/compiled_once.hpp"
#include "06_world/game_world/continuous_module.hpp"
#include "06_world/game_world/impact_modules.hpp"
#include "06_world/game_world/islands_module.hpp"
#include "06_world/game_world/sleeping_module.hpp"
#include "06_world/game_world/surfaces_module.hpp"

namespace cookbook
{

// [game_modules]
/// All modules of a world for a game; without sleeping unless bodies may sleep.
inline WorldModules game_modules(bool may_sleep)
{
  WorldModules modules;
  modules.list = {FlushSurfaces(), FindIslands(), HitEvents(), Restitution(), Continuous()};
  if (may_sleep)
  {
    modules.list.insert(
        modules.list.begin() + 2, Sleeping()); // first of all that asks who is awake
  }
  return modules;
}
// [game_modules]

} // namespace cookbook
