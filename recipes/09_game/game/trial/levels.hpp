#pragma once

/// \file
/// \brief The levels of the game, in the program itself: a page has no files.

#include "09_game/game/level.hpp"

namespace cookbook::game
{

/// The levels, in order: what stands in level_1.json, level_2.json and level_3.json.
const std::vector<Level>& built_in_levels();

} // namespace cookbook::game
